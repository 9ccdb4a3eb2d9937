// Fills the sample buffer with the head's depth, so that hair behind it loses. One invocation a sample: rows
// along y, since no more than 65535 workgroups are promised in one direction.
layout(local_size_x = 64) in;

layout(std430, binding = 0) writeonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headDepth;

// Hair that lies flat dips into the skin here and there; it is shown all the same.
const float kSkinDepthM = 0.015;

void main()
{
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    int across = int(target.x);
    if (at.x >= across)
        return;
    float depth = texelFetch(headDepth, at, 0).x;
    samples[at.y * across + at.x] =
        depth < 1.0 ? (depthKey(linearDepth(depth) + kSkinDepthM) << kDepthShift) | kHeadColour : kEmptySample;
}
