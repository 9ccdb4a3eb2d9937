// Fills the sample buffer with the head's depth, so that hair behind it loses. One invocation a sample.
layout(local_size_x = 64) in;

layout(std430, binding = 0) writeonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headDepth;

// Hair that lies flat dips into the skin here and there; it is shown all the same.
const float kSkinDepthM = 0.015;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    uint across = uint(target.x);
    if (i >= across * uint(target.y))
        return;
    float depth = texelFetch(headDepth, ivec2(i % across, i / across), 0).x;
    samples[i] = depth < 1.0 ? (depthKey(linearDepth(depth) + kSkinDepthM) << kDepthShift) | kHeadColour : kEmptySample;
}
