#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks at reports through headless Chromium.

usage: browser_test.py PROGRAM TESTVECTORS SIMULATED(0|1)
"""
import base64
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, require_browser
from pages import EVIL, Pages

STEPS = ["Pixels", "Gradient", "First contour", "Second contour", "Vertices", "Straight lines",
         "Regions", "Models", "Residuals"]

VISIBLE_LAYERS = """
  return figures.map((figure) => [...figure.svg.querySelectorAll('.layer')]
    .filter((layer) => getComputedStyle(layer).display !== 'none')
    .map((layer) => layer.dataset.layer).sort().join(' '));"""

# How many different colours the drawing in space has, and a sum that changes with its contents.
CANVAS = """
  const done = arguments[0], image = new Image();
  image.onload = () => {
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [image.width, image.height];
    const pen = canvas.getContext('2d');
    pen.drawImage(image, 0, 0);
    const words = new Uint32Array(pen.getImageData(0, 0, image.width, image.height).data.buffer);
    done({colours: new Set(words).size, sum: words.reduce((a, b) => (31 * a + b) % 1000003, 7)});
  };
  image.src = document.querySelector('#space-view canvas').toDataURL();"""


class PageTest(unittest.TestCase):
    """What all tests share; `plain` draws no WebGL, which makes most tests quick."""
    pages = plain = drawing = None

    def setUp(self):
        self.browser = self.plain

    def open(self, page):
        self.browser.open(page)

    def tearDown(self):
        self.assertEqual(self.browser.errors(), [], "the console shows errors")

    def js(self, script, *arguments):
        return self.browser.run(script, *arguments)

    def text(self, selector):
        return self.js("return document.querySelector(arguments[0]).textContent", selector)


class SpaceTest(PageTest):
    def setUp(self):
        self.browser = self.drawing

    def canvas(self):
        return self.browser.driver.execute_async_script(CANVAS)

    def test_the_scene_in_space_is_drawn_and_its_parts_can_be_switched(self):
        self.open(self.pages.scene)
        whole = self.canvas()
        self.assertGreater(whole["colours"], 200, "the drawing in space is blank")
        self.js("document.querySelector('#space-options input[name=models]').click()")
        self.assertNotEqual(self.canvas()["sum"], whole["sum"])
        self.js("document.querySelector('#space-options input[name=models]').click()")
        self.assertEqual(self.canvas()["sum"], whole["sum"])
        self.js("""document.getElementById('space-view').dispatchEvent(
            new KeyboardEvent('keydown', {key: 'ArrowLeft', cancelable: true}))""")
        self.assertNotEqual(self.canvas()["sum"], whole["sum"])

    def test_a_scene_without_objects_still_shows_table_and_cameras(self):
        self.open(self.pages.empty)
        self.assertGreater(self.canvas()["colours"], 50)
        self.assertEqual(self.browser.outside_requests(), [])


class ReportTest(PageTest):
    def test_every_part_of_the_page_is_there_and_nothing_comes_from_outside(self):
        self.open(self.pages.scene)
        self.assertEqual(self.js("return figures.length"), 3)
        self.assertEqual(self.js("""return [...document.querySelectorAll('[role=tab]')]
            .map((tab) => tab.textContent)"""), STEPS)
        for part in ["objects", "rejections", "hardware", "times", "space"]:
            self.assertTrue(self.text(f"#{part} h2"), part)
        self.assertIn("2 objects found: ", self.text(".result"))
        self.assertEqual(self.js("return document.querySelectorAll('#objects tbody tr').length"), 2)
        self.assertEqual(self.browser.outside_requests(), [])

    def test_the_pictures_of_every_view_can_be_decoded(self):
        self.open(self.pages.scene)
        sizes = self.browser.driver.execute_async_script("""
            const done = arguments[0];
            Promise.all([...document.querySelectorAll('#figures image')].map(async (node) => {
              const image = new Image();
              image.src = node.getAttribute('href');
              await image.decode();
              return `${image.naturalWidth}x${image.naturalHeight}`;
            })).then(done, (error) => done(String(error)));""")
        self.assertEqual(sizes, ["450x300"] * 12)  # three views of four pictures

    def test_each_step_shows_its_own_layers(self):
        self.open(self.pages.scene)
        seen = set()
        for index, name in enumerate(STEPS):
            self.js("document.querySelectorAll('[role=tab]')[arguments[0]].click()", index)
            layers = self.js(VISIBLE_LAYERS)
            wanted = " ".join(sorted(self.js("return kStages[arguments[0]].layers", index)))
            self.assertEqual(layers, [wanted] * 3, name)
            self.assertTrue(self.text("#stage-text").startswith(name))
            seen.add(layers[0])
        self.assertEqual(len(seen), len(STEPS), "two steps look the same")

    def test_seen_surfaces_are_listed_with_their_place_in_the_world(self):
        self.open(self.pages.scene)
        rows = self.js("""return [...document.querySelectorAll('.seen tbody tr')].map(
            (row) => [...row.cells].map((cell) => cell.textContent))""")
        self.assertGreater(len(rows), 5)
        for name, surface, views, area, normal, centre in rows:
            self.assertTrue(set(views.split(", ")) <= {"top", "side", "front"}, name)
            self.assertGreater(float(area), 0)
            self.assertAlmostEqual(sum(float(v) ** 2 for v in normal.split()), 1, delta=0.01)
            if views == "top":  # it looks down: a wall at the most, leaning by the lens's angle
                self.assertGreaterEqual(float(normal.split()[2]), -0.2)
            self.assertGreater(float(centre.split()[2]), -1)  # mm: nothing lies below the table

    def test_layers_can_be_mixed(self):
        self.open(self.pages.scene)
        self.js("document.querySelector('#mixer input[name=gradient]').click()")
        self.assertEqual(self.js(VISIBLE_LAYERS), ["gradient image models names"] * 3)

    def test_drawn_layers_have_something_in_them(self):
        self.open(self.pages.scene)
        for selector in [".corner", ".junction", ".region", ".outline", ".residual", ".segment"]:
            count = self.js("return document.querySelectorAll('#figures ' + arguments[0]).length",
                            selector)
            self.assertGreaterEqual(count, 3, selector)

    def test_keys_choose_steps_zoom_and_move(self):
        self.open(self.pages.scene)
        press = """arguments[0].dispatchEvent(new KeyboardEvent('keydown',
                   {key: arguments[1], bubbles: true, cancelable: true}))"""
        body = self.js("return document.body")
        self.js(press, body, "5")
        self.assertIn("vertices", self.js(VISIBLE_LAYERS)[0])
        view = self.js("return document.querySelector('svg.view')")
        box = "return document.querySelector('svg.view').getAttribute('viewBox')"
        boxes = [self.js(box)]
        for key in ["+", "ArrowRight", "+", "0"]:
            self.js(press, view, key)
            boxes.append(self.js(box))
        self.assertEqual(len(set(boxes[:4])), 4, boxes)
        self.assertEqual([float(v) for v in boxes[4].split()], [-0.5, -0.5, 450, 300])

    def test_a_rejected_hypothesis_is_drawn_on_request(self):
        self.open(self.pages.scene)
        drawn = "return figures.every((figure) => figure.rejected.getAttribute('d').length > 9)"
        self.assertFalse(self.js(drawn))
        self.js("document.querySelector('#rejections button').click()")
        self.assertTrue(self.js(drawn))
        self.js("document.querySelector('#rejections button').click()")
        self.assertFalse(self.js(drawn))

    def test_the_hardware_tells_its_clocks_or_that_it_has_none(self):
        self.open(self.pages.empty)
        self.assertIn("not available", self.text("#hardware"))
        self.open(self.pages.scene)
        if self.pages.front_end != "rtl":
            return
        self.assertIn("1.000", self.text("#hardware .card"))
        rate = "#hardware .clock + div .card strong"
        before = int(self.text(rate))
        self.js("""const input = document.getElementById('clock');
                   input.value = '200'; input.dispatchEvent(new Event('input'));""")
        self.assertAlmostEqual(int(self.text(rate)) / before, 2, delta=0.01)

    def test_a_scene_without_a_known_object_says_so(self):
        self.open(self.pages.empty)
        self.assertEqual(self.text(".result"), "No object of the library was found.")
        self.assertIn("The truth is not known.", self.text("#summary"))

    def test_names_that_are_markup_are_shown_as_they_are(self):
        self.open(self.pages.evil)
        self.assertEqual(self.text("h1"), f"Scene {EVIL}")
        self.assertIn(EVIL, self.text(".result"))
        self.assertIn(EVIL, self.text("figcaption"))
        self.assertEqual(self.js("return document.querySelectorAll('img').length"), 0)
        self.assertEqual(self.js("return typeof hacked"), "undefined")

    def test_an_evaluation_lists_all_scenes_and_opens_the_chosen_one(self):
        self.open(self.pages.evaluation)
        rows = "return document.querySelectorAll('.scenes tbody tr:not([hidden])').length"
        self.assertEqual(self.js(rows), 2)
        self.assertEqual(self.js("return document.querySelectorAll('.scenes .open').length"), 1)
        self.js("document.querySelector('.scenes .open').click()")
        self.assertIn("Scene 000037", self.text("#summary h2"))
        self.js("""const select = document.getElementById('filter');
                   select.value = 'full'; select.dispatchEvent(new Event('change'));""")
        self.assertEqual(self.js(rows), 1)
        self.assertEqual(self.browser.outside_requests(), [])

    def test_the_printed_page_shows_every_step_of_every_view(self):
        self.open(self.pages.scene)
        self.js("""window.addEventListener('afterprint', () => {}, {once: true});
                   window.addEventListener('beforeprint', () => {
                     window.printed = document.querySelectorAll('#sheet svg').length; });""")
        pdf = base64.b64decode(self.browser.driver.print_page())
        self.assertTrue(pdf.startswith(b"%PDF"))
        self.assertEqual(self.js("return window.printed"), 3 * len(STEPS))
        self.assertEqual(self.js("return document.querySelectorAll('#sheet svg').length"), 0)

    def test_without_webgl_the_page_says_so_and_keeps_the_rest(self):
        self.open(self.pages.scene)
        self.assertIn("no WebGL", self.text("#no-webgl"))
        self.assertEqual(self.js("return document.querySelectorAll('#objects tbody tr').length"), 2)

    def test_dark_and_light_differ(self):
        self.open(self.pages.scene)
        colour = "return getComputedStyle(document.body).backgroundColor"
        before = self.js(colour)
        self.js("document.getElementById('theme').click()")
        self.assertNotEqual(self.js(colour), before)


def main():
    require_browser()
    program, testvectors, simulated = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as folder:
        PageTest.pages = Pages(program, Path(testvectors), folder, simulated == "1")
        PageTest.plain, PageTest.drawing = Browser(webgl=False), Browser()
        try:
            done = unittest.main(argv=sys.argv[:1], exit=False)
        finally:
            PageTest.plain.close()
            PageTest.drawing.close()
    sys.exit(0 if done.result.wasSuccessful() else 1)


if __name__ == "__main__":
    main()
