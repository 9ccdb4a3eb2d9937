// Sums each column of an opacity grid away from the light or the eye (after deep opacity maps, Yuksel and Keyser 2008,
// in even layers), and clears it for the next frame. Out: hair's area over the area it covers. One invocation a column.
layout(local_size_x = 64) in;

layout(std430, binding = 3) buffer Voxels { uint voxels[]; };
layout(r32f, binding = 0) writeonly uniform image3D opacity;

uniform int gridSide;
uniform int firstLayer; // First layer of this grid in the voxels; 0 in the light's grid.
uniform float unit; // Opacity of a voxel's unit.

// As in view/rendering/eye_grid.h.
const float kMostOfVoxel = 2.5;
const float kMostWithinVoxel = 12.0;

void main()
{
    int column = int(gl_GlobalInvocationID.x);
    if (column >= gridSide * gridSide)
        return;
    ivec2 xy = ivec2(column % gridSide, column / gridSide);
    float sum = 0.0;
    for (int z = 0; z < gridSide; ++z) {
        int at = ((firstLayer + z) * gridSide + xy.y) * gridSide + xy.x;
        float all = float(voxels[at]) * unit;
        float here = firstLayer > 0 ? min(all, kMostWithinVoxel) : all;
        voxels[at] = 0u;
        imageStore(opacity, ivec3(xy, z), vec4(sum + 0.5 * here));
        sum += firstLayer > 0 ? min(here, kMostOfVoxel) : here;
    }
}
