// Averages a pixel's samples in linear light: hair where hair is nearest, else the head, else the background; then the
// brush rings. Out: sRGB as encoded.
layout(std430, binding = 0) readonly buffer Samples { uint samples[]; };
layout(binding = 0) uniform sampler2D headColour;
layout(binding = 1) uniform sampler2D headDepth;
layout(location = 0) out vec4 srgb;

void main()
{
    ivec2 per = ivec2(target.zw);
    ivec2 corner = ivec2(gl_FragCoord.xy) * per;
    int across = int(target.x);
    vec3 behind = mix(background[0].rgb, background[1].rgb, gl_FragCoord.y * target.w / target.y);
    vec3 sum = vec3(0.0);
    for (int y = 0; y < per.y; ++y)
        for (int x = 0; x < per.x; ++x) {
            ivec2 at = corner + ivec2(x, y);
            uint value = samples[at.y * across + at.x];
            if (value == kEmptySample)
                sum += behind;
            else if ((value & kColourMask) == kHeadColour) {
                vec3 c = texelFetch(headColour, at, 0).rgb;
                sum += c * c;
            } else
                sum += unpackColour(value);
        }
    srgb = vec4(srgbFromLinear(sum / float(per.x * per.y)), 1.0);
}
