# Run by Blender: reads a `.hair` file with our add-on, and tells, as one line of JSON, what the Curves object holds.
# With a third argument it is rendered to that picture, from the front.
import importlib.util
import json
import math
import sys
import tempfile

import bpy
import numpy

script, path, *picture = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
spec = importlib.util.spec_from_file_location("hair_paint_import", script)
addon = importlib.util.module_from_spec(spec)
spec.loader.exec_module(addon)
addon.register()
cut = tempfile.NamedTemporaryFile(suffix=".hair")
cut.write(open(path, "rb").read()[:1000])
cut.flush()
try:
    bpy.ops.import_curves.hair_paint(filepath=cut.name)
except RuntimeError as problem:
    print("CUT " + str(problem).strip())
bpy.ops.import_curves.hair_paint(filepath=path)
made = bpy.context.view_layer.objects.active
curves = made.data


def values(name, key, width):
    flat = numpy.empty(width * len(curves.points), dtype=numpy.float32)
    curves.attributes[name].data.foreach_get(key, flat)
    return flat.reshape(-1, width)


print("READ " + json.dumps({
    "type": made.type,
    "sizes": [curve.points_length for curve in curves.curves],
    "positions": values("position", "vector", 3).round(7).tolist(),
    "radius": values("radius", "value", 1)[:, 0].round(9).tolist(),
    "colour": values("hair_color", "color", 4).round(5).tolist(),
    "materials": [m.name for m in curves.materials],
}))
if picture:
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 32
    scene.cycles.use_denoising = False
    scene.render.resolution_x = scene.render.resolution_y = 512
    scene.render.filepath = picture[0]
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (0.0, -0.95, -0.06)
    camera.rotation_euler = (math.pi / 2, 0.0, 0.0)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.world = bpy.data.worlds.new("World")
    scene.world.color = (0.6, 0.6, 0.6)
    light = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    light.data.energy = 4.0
    light.rotation_euler = (0.8, 0.3, 0.0)
    scene.collection.objects.link(light)
    bpy.ops.render.render(write_still=True)
