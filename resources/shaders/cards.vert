// Hair cards, Hd to the screen, and the light that white ones would throw back: it reaches around them, as it does
// through hair.
layout(location = 0) in vec3 placeHd;
layout(location = 1) in vec3 normalHd;
layout(location = 2) in vec2 cornerUv;
out vec2 uv;
out vec3 light;

void main()
{
    const float kWrap = 0.35;
    vec3 n = mat3(woFromHd) * normalHd;
    light = 0.6 * irradianceAt(n);
    vec3 lamps[3] = vec3[](keyWo.xyz, fillWo.xyz, rimWo.xyz);
    vec3 lampColours[3] = vec3[](keyColour.rgb, fillColour.rgb, rimColour.rgb);
    for (int i = 0; i < 3; ++i)
        light += 0.7 * clamp((dot(n, lamps[i]) + kWrap) / (1.0 + kWrap), 0.0, 1.0) * lampColours[i];
    uv = cornerUv;
    gl_Position = projectionFromWo * (woFromHd * vec4(placeHd, 1.0));
}
