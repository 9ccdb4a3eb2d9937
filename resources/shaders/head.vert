// The head, Hd to the screen; with SOLID a body that is worn, of a mesh around the unit ball.
layout(location = 0) in vec3 meshPosition;
layout(location = 1) in vec3 meshNormal;
layout(location = 2) in vec4 skinMarks; // Sky, lips, lids, blush.
layout(location = 4) in vec2 meshUv;
out vec2 skinUv;
#ifndef SOLID
layout(location = 3) in vec4 scalpTint; // See ScalpTint::Texel.
#endif
#ifdef SOLID
uniform vec4 solidCentreHd;
uniform vec4 solidSemiAxesM;
uniform vec4 solidRotation; // Quaternion: x, y, z, w.
#endif
out vec3 skinHd;
out vec3 skinWo;
out vec3 normalWo;
out vec4 marks;
out vec4 tint;

vec3 turnedBy(vec4 q, vec3 p)
{
    return p + 2.0 * cross(q.xyz, cross(q.xyz, p) + q.w * p);
}

void main()
{
    vec3 positionHd = meshPosition;
    vec3 normalHd = meshNormal;
    skinUv = meshUv;
#ifdef SOLID
    positionHd = solidCentreHd.xyz + turnedBy(solidRotation, meshPosition * solidSemiAxesM.xyz);
    normalHd = turnedBy(solidRotation, normalize(meshNormal / solidSemiAxesM.xyz));
#endif
    // The shoulders stay while the head turns: back by what has turned too much. As pushOutOfBust in
    // constraints/neck_contact_inl.h.
    float below = smoothstep(0.0, 1.0, (neckPivotHd.w - positionHd.y) * neckReach.x);
    vec4 turn = normalize(mix(vec4(0.0, 0.0, 0.0, 1.0), neckTurn, below));
    vec4 back = vec4(-turn.xyz, turn.w);
    vec4 standsWo = woFromHd * vec4(turnedBy(back, positionHd - neckPivotHd.xyz) + neckPivotHd.xyz, 1.0);
    skinHd = positionHd;
    skinWo = standsWo.xyz;
    normalWo = mat3(woFromHd) * turnedBy(back, normalHd);
    marks = skinMarks;
#ifdef SOLID
    tint = vec4(0.0);
#else
    tint = scalpTint;
#endif
    gl_Position = projectionFromWo * standsWo;
}
