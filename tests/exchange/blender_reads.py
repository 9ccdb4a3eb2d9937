# Run by Blender: reads a file with Blender's own importer and tells, as one line of JSON, what it holds.
import json
import sys

import bpy
import numpy

numpy.bool = bool  # Blender 3.4's glTF importer still asks NumPy for it.
path = sys.argv[sys.argv.index("--") + 1]
bpy.ops.wm.read_factory_settings(use_empty=True)
if path.endswith(".obj"):
    bpy.ops.wm.obj_import(filepath=path)
else:
    bpy.ops.import_scene.gltf(filepath=path)
objects = []
for item in bpy.data.objects:
    if item.type != "MESH":
        continue
    mesh = item.data
    flat = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", flat)
    matrix = numpy.array(item.matrix_world, dtype=numpy.float64)
    positions = flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
    objects.append({"name": item.name, "edges": len(mesh.edges), "faces": len(mesh.polygons),
                    "colours": len(mesh.color_attributes), "positions": positions.round(7).tolist()})
print("READ " + json.dumps(objects))
