#!/usr/bin/python3
"""Has other programs open what `hairpaint export` writes, and compares counts and positions.

    check.py PROGRAM FOLDER     PROGRAM: hairpaint; FOLDER: where the judges' packages are installed and files are written

Judges: Blender (its own importers of OBJ and glTF, and our add-on), the Khronos validator (glTF), tinyusdz (USD); of
cards also compare_cards.py, three.js with three-vrm in Chromium, which leaves pictures in FOLDER, and Godot 3; three-vrm
and the validator also of an avatar. What the files are to hold is read from the `.hair` of the same hair. Prints a line a check
and ends with "N passed, M failed".
"""
import base64
import json
import os
import re
import shutil
import struct
import subprocess
import sys
import time
from pathlib import Path

from browser import seen_in_browser

HERE = Path(__file__).resolve().parent
STYLES = {"straight": "Long straight", "plaits": "Two plaits", "curls": "Ringlets"}
CARD_STYLES = STYLES | {"bob": "Bob", "afro": "Round afro"}
CARD_OPTIONS = ["--cards", "--lods", "3", "--bones", "--with-head"]
SWINGING = "straight"  # Among them.
OPTIONS = ["--hairs", "3000", "--tolerance", "0.2"]
NEAR = 2e-6


class Judge:
    def __init__(self, program, folder):
        self.program = Path(program).resolve()
        self.folder = Path(folder).resolve()
        self.folder.mkdir(parents=True, exist_ok=True)
        self.passed = self.failed = 0

    def check(self, name, good, told=""):
        self.passed += good
        self.failed += not good
        print(f"{'PASS' if good else 'FAIL'} {name}{' ' + str(told) if told and not good else ''}", flush=True)

    def run(self, *words):
        return subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=600)

    def export(self, style, suffix, *options):
        path = self.folder / f"{style}.{suffix}"
        done = self.run(self.program, "export", self.folder / f"{style}.hairpaint", "-o", path, *OPTIONS, *options)
        if done.returncode != 0:
            sys.exit(done.stderr)
        return path


def read_hair(path):
    """Points per strand, and the points, as the `.hair` format has them."""
    data = path.read_bytes()
    strands, points = struct.unpack_from("<II", data, 4)
    counts = [n + 1 for n in struct.unpack_from(f"<{strands}H", data, 128)]
    flat = struct.unpack_from(f"<{3 * points}f", data, 128 + 2 * strands)
    return counts, list(zip(flat[0::3], flat[1::3], flat[2::3]))


def farthest(a, b):
    if len(a) != len(b):
        return float("inf")
    return max(max(abs(x - y) for x, y in zip(p, q)) for p, q in zip(a, b))


def blender_reads(judge, path):
    done = judge.run("blender", "-b", "--factory-startup", "-P", HERE / "blender_reads.py", "--", path)
    found = re.search(r"^READ (.*)$", done.stdout, re.M)
    return json.loads(found[1]) if found else []


def check_obj(judge, style, counts, points):
    objects = blender_reads(judge, judge.export(style, "obj", "--target", "blender"))
    positions = [p for item in objects for p in item["positions"]]
    judge.check(f"{style}: Blender reads as many points of the OBJ", len(positions) == len(points))
    judge.check(f"{style}: and as many segments", sum(i["edges"] for i in objects) == len(points) - len(counts))
    upright = [(x, -z, y) for x, y, z in points]  # In Blender z is up.
    judge.check(f"{style}: at the same positions", farthest(positions, upright) < NEAR, farthest(positions, upright))
    judge.check(f"{style}: with colours", bool(objects) and all(i["colours"] == 1 for i in objects))


def check_addon(judge, style, counts, points):
    addon = HERE.parents[1] / "resources" / "blender" / "hair_paint_import.py"
    for target in ("any", "unreal"):
        path = judge.export(style, "hair", "--target", target)
        done = judge.run("blender", "-b", "--factory-startup", "-P", HERE / "blender_addon.py", "--", addon, path)
        found = re.search(r"^READ (.*)$", done.stdout, re.M)
        made = json.loads(found[1]) if found else {"type": done.stderr}
        judge.check(f"{style}: our add-on makes Curves in Blender of the file for {target}",
                    made["type"] == "CURVES", made["type"])
        judge.check(f"{style}: our add-on says what is wrong with a part of it", "it is cut short" in done.stdout)
        if not found:
            continue
        upright = [(x, -z, y) for x, y, z in points]
        away = farthest(made["positions"], upright)
        judge.check(f"{style}: as many, with as many points", made["sizes"] == counts)
        judge.check(f"{style}: at the same positions", away < NEAR, away)
        judge.check(f"{style}: as thin as hair", 5e-6 < max(made["radius"]) < 2e-4, max(made["radius"]))
        judge.check(f"{style}: with colour and material",
                    len(made["colour"]) == len(points) and made["materials"] == ["Hair"])


def check_gltf(judge, style, counts, points):
    path = judge.export(style, "glb")
    done = judge.run("node", HERE / "validate_gltf.js", path)
    report = json.loads(done.stdout)["issues"] if done.returncode == 0 else {"numErrors": done.stderr}
    judge.check(f"{style}: the glTF has no errors", report.get("numErrors") == 0, report)
    judge.check(f"{style}: and no warnings", report.get("numWarnings") == 0, report)
    objects = blender_reads(judge, path)
    positions = [p for item in objects for p in item["positions"]]
    middles = [[(a + b) / 2 for a, b in zip(*pair)] for pair in zip(positions[0::2], positions[1::2])]
    judge.check(f"{style}: Blender reads two triangles a segment of it",
                sum(i["faces"] for i in objects) == 2 * (len(points) - len(counts)))
    upright = [(x, -z, y) for x, y, z in points]
    judge.check(f"{style}: along the strands", farthest(middles, upright) < NEAR, farthest(middles, upright))


def check_cards(judge, style):
    """At the usual budget, fallen as `render` shows it."""
    project = judge.folder / f"{style}.hairpaint"
    cards, strands = judge.folder / f"{style}-cards.glb", judge.folder / f"{style}-all.hair"
    for path, options in ((cards, CARD_OPTIONS), (strands, [])):
        done = judge.run(judge.program, "export", project, "-o", path, "--settle", "2", *options)
        if done.returncode != 0:
            sys.exit(done.stderr)
    done = judge.run("node", HERE / "validate_gltf.js", cards)
    report = json.loads(done.stdout)["issues"] if done.returncode == 0 else {"numErrors": done.stderr}
    judge.check(f"{style}: the cards' glTF has no errors", report.get("numErrors") == 0, report)
    judge.check(f"{style}: and no warnings", report.get("numWarnings") == 0, report)
    objects = blender_reads(judge, cards)
    done = judge.run("/usr/bin/python3", HERE / "compare_cards.py", strands, cards)
    if done.returncode != 0:
        sys.exit(done.stderr)
    found = json.loads(done.stdout)
    faces = {i["name"]: i["faces"] for i in objects}
    levels = [sum(n for name, n in faces.items() if name.endswith(f"_LOD{level}")) for level in range(3)]
    judge.check(f"{style}: Blender reads all {found['triangles']} triangles, 15,000 at most",
                levels[0] == found["triangles"] <= 15000, faces)
    judge.check(f"{style}: and each level has half the triangles of the one before",
                all(0.45 < fewer / more <= 0.501 for more, fewer in zip(levels, levels[1:])), levels)
    judge.check(f"{style}: and the head", faces.get("Head mesh", 0) > 1000, faces)
    judge.check(f"{style}: their atlas is full enough ({found['filled']})", found["filled"] >= 0.7)
    sides = found["sides"]
    overlap, away = min(s["overlap"] for s in sides.values()), max(s["away"] for s in sides.values())
    judge.check(f"{style}: the cards' silhouettes are the strands' from four sides (least overlap {overlap})",
                overlap >= 0.9, sides)
    judge.check(f"{style}: and so are their colours (farthest {away})", away <= 0.05, sides)
    picture = judge.folder / "level.ppm"
    for level, least in ((1, 0.85), (2, 0.8)):
        done = judge.run("/usr/bin/python3", HERE / "compare_cards.py", strands, cards, picture, level)
        sides = json.loads(done.stdout)["sides"] if done.returncode == 0 else {"none": {"overlap": 0}}
        overlap = min(s["overlap"] for s in sides.values())
        judge.check(f"{style}: silhouettes of level {level} are near (least overlap {overlap})", overlap >= least, sides)
    if style == SWINGING:
        check_swinging(judge, style, cards, faces)
        check_godot(judge, style, cards, faces)


def check_swinging(judge, style, cards, faces):
    found = seen_in_browser(HERE / "avatar.html", cards, judge.folder)
    judge.check(f"{style}: three.js reads the cards", "error" not in found, found.get("error"))
    if "error" in found:
        return
    for name in ("still", "swung"):
        if name in found:
            (judge.folder / f"{style}-{name}.png").write_bytes(base64.b64decode(found[name].split(",")[1]))
    first = {name.replace(" ", "_"): n for name, n in faces.items() if not name.endswith(("_LOD1", "_LOD2"))}
    judge.check(f"{style}: it draws the first level and the head", found["meshes"] == first, found["meshes"])
    moved = found["moved"]
    judge.check(f"{style}: three-vrm lets {found['springs']} joints swing while the head turns (up to {max(moved, default=0):.3f} m)",
                found["springs"] > 20 and 0.01 < max(moved) < 0.5 and max(moved[10:]) - min(moved[10:]) > 0.01, moved)


def check_avatar(judge):
    """A body with arms that hang, its joints turned every way, becomes a VRM."""
    body, project, avatar = (judge.folder / f"body.{ending}" for ending in ("glb", "hairpaint", "vrm"))
    for words in (["/usr/bin/python3", HERE / "mannequin.py", body],
                  [judge.program, "new", "-o", project, "--head", body, "--preset", CARD_STYLES[SWINGING]],
                  [judge.program, "export", project, "-o", avatar, "--settle", "2", "--author", "Ann"]):
        done = judge.run(*words)
        if done.returncode != 0:
            sys.exit(done.stderr)
    done = judge.run("node", HERE / "validate_gltf.js", avatar)
    report = json.loads(done.stdout)["issues"] if done.returncode == 0 else {"numErrors": done.stderr}
    judge.check("avatar: the VRM's glTF has no errors", report.get("numErrors") == 0, report)
    judge.check("avatar: and no warnings", report.get("numWarnings") == 0, report)
    found = seen_in_browser(HERE / "avatar.html", avatar, judge.folder)
    judge.check("avatar: three-vrm reads it", "error" not in found and "avatar" in found, found.get("error"))
    if "avatar" not in found:
        return
    for name in ("still", "swung"):
        (judge.folder / f"avatar-{name}.png").write_bytes(base64.b64decode(found[name].split(",")[1]))
    meta, bones = found["avatar"]["meta"], found["avatar"]["bones"]
    judge.check("avatar: as VRM 1.0 of its author",
                (meta["metaVersion"], meta["name"], meta["authors"]) == ("1", "body", ["Ann"]), meta)
    expected = {"head": (0, 1.5, 0), "leftHand": (.7, 1.4, 0), "rightHand": (-.7, 1.4, 0), "leftFoot": (.1, .08, 0),
                "hips": (0, .95, 0)}
    away = farthest([bones.get(name, (9, 9, 9)) for name in expected], list(expected.values()))
    judge.check(f"avatar: with {len(bones)} bones, the arms held out", len(bones) == 20 and away < 1e-3, bones)
    rest, down = found["avatar"]["atRest"], found["avatar"]["armDown"]
    judge.check("avatar: the skin reaches as far", abs(rest[1][0] - .74) < .02 and abs(rest[0][0] + .74) < .02, rest)
    judge.check("avatar: an arm that is turned takes its skin along",
                down[1][0] < .4 and abs(down[0][0] - rest[0][0]) < 1e-3, down)
    moved = found["moved"]
    judge.check(f"avatar: its hair swings when the head's bone turns (up to {max(moved, default=0):.3f} m)",
                found["springs"] > 20 and .01 < max(moved) < .5, moved)


def check_godot(judge, style, cards, faces):
    project = judge.folder / "godot"
    shutil.rmtree(project, ignore_errors=True)
    project.mkdir()
    shutil.copy(cards, project / "cards.glb")
    (project / "project.godot").write_text("config_version=4\n[application]\nconfig/name=\"check\"\n")
    godot = ["godot3-server", "--path", str(project)]
    home = os.environ | {"HOME": str(project)}
    # The editor imports, but does not always end by itself.
    editor = subprocess.Popen(godot + ["--editor", "--quit"], env=home, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    for _ in range(240):
        if list(project.glob(".import/cards.glb-*.md5")):
            break
        time.sleep(0.5)
    editor.terminate()
    editor.wait()
    done = subprocess.run(godot + ["-s", str(HERE / "godot_reads.gd")], env=home, capture_output=True, text=True,
                          timeout=120)
    text = re.search(r"^READ (.*)$", done.stdout, re.M)
    found = json.loads(text[1]) if text else {"meshes": {}, "bones": 0, "skinned": 0}
    judge.check(f"{style}: Godot imports as many triangles of each mesh",
                {name: int(n) for name, n in found["meshes"].items()} == faces, found or done.stderr)
    judge.check(f"{style}: with a skeleton ({found['bones']} bones) that holds all of them",
                found["bones"] > 20 and found["skinned"] == len(faces), found)


def numbers_of(text, name):
    found = re.search(re.escape(name) + r" = \[(.*?)\]", text, re.S)
    return [float(word) for word in re.findall(r"-?[0-9.]+(?:e-?[0-9]+)?", found[1])] if found else []


def check_usd(judge, style, counts, points):
    for target, turn in (("any", lambda p: p), ("unreal", lambda p: (100 * p[0], -100 * p[2], 100 * p[1]))):
        path = judge.export(style, "usda", "--target", target)
        done = judge.run("node", HERE / "read_usd.mjs", judge.folder / "node_modules" / "tinyusdz", path)
        read = json.loads(done.stdout) if done.returncode == 0 else {"ok": False, "error": done.stderr, "text": ""}
        judge.check(f"{style}: tinyusdz reads the USD text for {target}", read["ok"] and not read["error"], read["error"])
        strands = read["text"].split('def BasisCurves "Guides"')[0]
        flat = numbers_of(strands, "point3f[] points")
        made = list(zip(flat[0::3], flat[1::3], flat[2::3]))
        away = farthest(made, [turn(p) for p in points])
        judge.check(f"{style}: with the same curves", numbers_of(strands, "curveVertexCounts") == counts)
        judge.check(f"{style}: at the same positions", away < (NEAR if target == "any" else 100 * NEAR), away)
        judge.check(f"{style}: with Unreal's attributes",
                    all(len(numbers_of(strands, f"primvars:groom_{name}")) == width * len(counts)
                        for name, width in (("id", 1), ("root_uv", 2), ("width", 1))))
    path = judge.export(style, "usdz")
    done = judge.run("node", HERE / "read_usd.mjs", judge.folder / "node_modules" / "tinyusdz", path)
    judge.check(f"{style}: tinyusdz reads the USD archive", done.returncode == 0 and json.loads(done.stdout)["ok"])


def make_project(judge, style, preset):
    made = judge.run(judge.program, "new", "-o", judge.folder / f"{style}.hairpaint", "--preset", preset)
    if made.returncode != 0:
        sys.exit(made.stderr)


def main():
    judge = Judge(*sys.argv[1:3])
    for style, preset in STYLES.items():
        make_project(judge, style, preset)
        counts, points = read_hair(judge.export(style, "hair"))
        check_obj(judge, style, counts, points)
        check_addon(judge, style, counts, points)
        check_gltf(judge, style, counts, points)
        check_usd(judge, style, counts, points)
    for style, preset in CARD_STYLES.items():
        if style not in STYLES:
            make_project(judge, style, preset)
        check_cards(judge, style)
    check_avatar(judge)
    print(f"{judge.passed} passed, {judge.failed} failed")
    sys.exit(judge.failed != 0)


if __name__ == "__main__":
    main()
