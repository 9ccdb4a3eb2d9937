// Hair cards, Hd to the screen, and the light on the hair that lies along them, over its colour.
layout(location = 0) in vec3 positionHd;
layout(location = 1) in vec3 normalHd;
layout(location = 2) in vec3 tangentHd; // Unit, toward the tips.
layout(location = 3) in vec3 hairColour; // Around there; linear.
layout(location = 4) in vec2 cornerUv;
layout(location = 5) in vec2 material; // Shine, roughness.
uniform float crossed; // Hair between it and its lights, area over area.
out vec2 uv;
out vec3 light;

void main()
{
    const float kRound = 0.04; // m: a lock is lit as if it bulged by that, so that its sides differ.
    mat3 turn = mat3(woFromHd);
    vec4 positionWo = woFromHd * vec4(positionHd, 1.0);
    vec3 colour = clamp(hairColour, 0.004, 1.0);
    HairPoint point = HairPoint(positionWo.xyz + kRound * (turn * normalHd), turn * tangentHd, colour, fibreDepth(colour),
                                0.0, crossed, crossed, crossed, 1.0, 1.0);
    light = hairLight(point, material.x, material.y) / colour;
    uv = cornerUv;
    gl_Position = projectionFromWo * positionWo;
}
