# Run by Godot 3 in a project that holds cards.glb: prints, as one line of JSON, what its own importer made of it.
extends SceneTree

var found = {"meshes": {}, "bones": 0, "skinned": 0}


func look(node):
    if node is MeshInstance and node.mesh:
        var indices = 0
        for surface in node.mesh.get_surface_count():
            indices += node.mesh.surface_get_array_index_len(surface)
        found["meshes"][node.name] = indices / 3
        found["skinned"] += int(node.skin != null)
    if node is Skeleton:
        found["bones"] += node.get_bone_count()
    for child in node.get_children():
        look(child)


func _init():
    look(load("res://cards.glb").instance())
    print("READ " + to_json(found))
    quit()
