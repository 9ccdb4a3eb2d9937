// A shop-window head: matte, warm, light grey porcelain under a soft key light, sky and floor, with a faint rim.
// Out: square root of the linear colour; alpha 1 where there is head.
in vec3 placeWo;
in vec3 normalWo;
layout(location = 0) out vec4 rootColour;

void main()
{
    vec3 n = normalize(normalWo);
    vec3 v = normalize(eyeWo.xyz - placeWo);
    if (dot(n, v) < 0.0 && !gl_FrontFacing)
        n = -n;
    vec3 l = lightWo.xyz;
    const vec3 albedo = vec3(0.51, 0.455, 0.412);
    float key = clamp(dot(n, l) * 0.75 + 0.25, 0.0, 1.0);
    key *= key;
    vec3 sky = mix(vec3(0.78, 0.72, 0.68), vec3(0.98, 1.0, 1.05), n.y * 0.5 + 0.5);
    float rim = pow(1.0 - max(dot(n, v), 0.0), 3.0);
    vec3 h = normalize(l + v);
    float sheen = pow(max(dot(n, h), 0.0), 18.0);
    vec3 colour = albedo * (key * 0.85 * lightColour.rgb + sky * (lightWo.w * (0.55 + 0.45 * n.y * 0.5 + 0.2)));
    colour += lightColour.rgb * (sheen * 0.035) + sky * (rim * 0.06 * (0.5 + lightWo.w));
    rootColour = vec4(sqrt(clamp(colour, 0.0, 1.0)), 1.0);
}
