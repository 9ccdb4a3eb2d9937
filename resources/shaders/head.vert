// The head, Hd to the screen.
layout(location = 0) in vec3 positionHd;
layout(location = 1) in vec3 normalHd;
out vec3 placeWo;
out vec3 normalWo;

void main()
{
    vec4 place = woFromHd * vec4(positionHd, 1.0);
    placeWo = place.xyz;
    normalWo = mat3(woFromHd) * normalHd;
    gl_Position = projectionFromWo * place;
}
