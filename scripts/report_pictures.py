#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the pictures of the reports that README and docs show: docs/images/report_*.png, story_*.png.

Needs the built program and the packages of scripts/packages-test.txt; pngquant makes the files
smaller where it is installed.

usage: report_pictures.py [SECTION]...   report, story, evaluation; all without
"""
import base64
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(root / "tests/report"))
from browser import Browser, require_browser  # noqa: E402

images = root / "docs/images"
program = root / "build/release/sw/cli/trihedron"
LOOKS = {"cad": "cad-two/000017", "studio": "studio-two/000034", "lab": "lab-stacked/000056",
         "lab_hd": "lab-hd/000060"}

# The story follows pixel (191, 16) of the top view of studio-two/000034: docs/story.md.
PIXEL = (191, 16)
STEPS = ["pixels", "gradient", "first_contour", "second_contour", "vertices", "lines", "regions",
         "models", "residuals"]
ZOOM_ON_PIXEL = """
  const [x, y] = arguments, figure = figures[0];
  figure.node.classList.add('wide');
  figure.box = [x - 24, y - 14, 48, 32];
  figure.svg.append(drawing('rect', {x: x - 0.5, y: y - 0.5, width: 1, height: 1, fill: 'none',
    stroke: '#ffffff', 'stroke-width': 2, 'vector-effect': 'non-scaling-stroke'}));
  figure.node.style.maxWidth = '480px';
  figure.update();"""


def save(name, png):
    file = images / name
    file.write_bytes(png)
    if shutil.which("pngquant"):
        subprocess.run(["pngquant", "--force", "--strip", "--speed", "1", "--quality", "70-95",
                        "--output", file, file], check=True)
    print(f"{file.relative_to(root)}: {file.stat().st_size // 1024} KiB")


def page(folder, *arguments):
    file = Path(folder) / "page.html"
    subprocess.run([program, *map(str, arguments), "--models", "testvectors/models10", "--report",
                    file], check=True, stdout=subprocess.DEVNULL, cwd=root)
    return file


def hide_times(browser):
    """Times belong to the machine that wrote the page; a busy one shows others."""
    browser.run("""document.head.append(element('style', {}, `#summary .card:last-child,
        #overview-sets :is(th, td):last-child, .scenes :is(th, td):nth-child(8)
        {display: none}`));""")


def clipped(browser, first, last, scale=1.0):
    """The page from the top of one element to the bottom of another, as PNG."""
    hide_times(browser)
    box = browser.run("""
      const a = document.querySelector(arguments[0]).getBoundingClientRect();
      const b = document.querySelector(arguments[1]).getBoundingClientRect();
      return [a.top + scrollY - 8, b.bottom - a.top + 16, innerWidth];""", first, last)
    shot = browser.driver.execute_cdp_cmd("Page.captureScreenshot", {
        "captureBeyondViewport": True, "clip": {"x": 0, "y": max(0, box[0]), "width": box[2],
                                                "height": box[1], "scale": scale}})
    return base64.b64decode(shot["data"])


def report(folder):
    browser = Browser(size="1120,1000")
    for look, scene in LOOKS.items():
        browser.open(page(folder, "recognize", f"testvectors/scenes/{scene}"))
        save(f"report_{look}.png", clipped(browser, "#views", "#space", 0.75))
        if look == "studio":
            save("report.png", clipped(browser, "header.top", "#objects table"))
    browser.close()


def story(folder):
    browser = Browser(webgl=False, size="1120,1000")
    browser.open(page(folder, "recognize", f"testvectors/scenes/{LOOKS['studio']}"))
    browser.run(ZOOM_ON_PIXEL, *PIXEL)
    for index, step in enumerate(STEPS):
        browser.run("showStage(arguments[0])", index)
        save(f"story_{step}.png", browser.driver.find_element("css selector", "svg.view")
             .screenshot_as_png)
    browser.close()


def evaluation(folder):
    browser = Browser(webgl=False, size="1120,1000")
    browser.open(page(folder, "evaluate", "testvectors/scenes"))
    save("report_evaluation.png", clipped(browser, "header.top", ".scenes tr:nth-child(5)"))
    browser.close()


def main():
    require_browser()
    sections = {"report": report, "story": story, "evaluation": evaluation}
    with tempfile.TemporaryDirectory() as folder:
        for name in sys.argv[1:] or sections:
            sections[name](folder)


if __name__ == "__main__":
    main()
