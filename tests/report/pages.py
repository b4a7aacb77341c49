# SPDX-License-Identifier: Apache-2.0
"""Writes the reports that the browser tests look at, with the program itself."""
import json
import shutil
import subprocess
import zlib
from pathlib import Path

EVIL = "<img src=x onerror=hacked()>"


def grey_png(width, height, level):
    """The bytes of a PNG of one grey level."""
    def chunk(kind, body):
        return (len(body).to_bytes(4, "big") + kind + body
                + zlib.crc32(kind + body).to_bytes(4, "big"))
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + bytes([8, 0, 0, 0, 0])
    rows = zlib.compress(b"".join(b"\0" + bytes([level]) * width for _ in range(height)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", rows)
            + chunk(b"IEND", b""))


class Pages:
    """The pages, made in `folder`: scene, empty, evil, evaluation."""

    def __init__(self, program, testvectors, folder, simulated):
        self.program, self.folder = program, Path(folder)
        self.models = testvectors / "models10"
        self.front_end = "rtl" if simulated else "golden"
        studio = testvectors / "scenes/studio-two"
        self.scene = self.recognize(studio / "000034", "scene.html", self.front_end, 0)
        self.empty = self.recognize(self.empty_scene(studio / "000034"), "empty.html", "golden", 1)
        self.evil = self.recognize(self.evil_scene(studio / "000034"), "evil.html", "golden", 0,
                                   self.evil_models())
        self.evaluation = self.folder / "evaluation.html"
        self.run("evaluate", studio, "--models", self.models, "--frontend", "golden",
                 "--report", self.evaluation, "--report-scenes", "000037")

    def run(self, *arguments, expected=0):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True)
        assert done.returncode == expected, f"{arguments}: {done.returncode}, {done.stderr}"

    def recognize(self, scene, name, front_end, expected, models=None):
        page = self.folder / name
        self.run("recognize", scene, "--models", models or self.models, "--frontend", front_end,
                 "--report", page, expected=expected)
        return page

    def empty_scene(self, source):
        """The cameras of a scene and views with nothing in them."""
        scene = self.folder / "000001"
        (scene / "gray").mkdir(parents=True)
        shutil.copy(source / "scene_camera.json", scene)
        for view in range(3):
            (scene / f"gray/00000{view}.png").write_bytes(grey_png(450, 300, 120))
        return scene

    def evil_scene(self, source):
        """A scene whose name, kind and views are markup."""
        scene = self.folder / EVIL
        shutil.copytree(source, scene)
        (scene / "scene_kind.json").write_text(json.dumps({"look": f"</script>{EVIL}"}))
        cameras = json.loads((scene / "scene_camera.json").read_text())
        for camera in cameras.values():
            camera["view"] = EVIL
        (scene / "scene_camera.json").write_text(json.dumps(cameras))
        return scene

    def evil_models(self):
        """The library under names that are markup."""
        models = self.folder / "models"
        shutil.copytree(self.models, models)
        numbers = [int(mesh.stem[4:]) for mesh in models.glob("obj_*.ply")]
        (models / "models_names.json").write_text(
            json.dumps({str(number): f"{EVIL}{number}" for number in numbers}))
        return models
