// The head, Hd to the screen.
layout(location = 0) in vec3 positionHd;
layout(location = 1) in vec3 normalHd;
layout(location = 2) in vec4 skinMarks; // Sky, lips, lids, blush.
out vec3 placeHd;
out vec3 placeWo;
out vec3 normalWo;
out vec4 marks;

void main()
{
    vec4 place = woFromHd * vec4(positionHd, 1.0);
    placeHd = positionHd;
    placeWo = place.xyz;
    normalWo = mat3(woFromHd) * normalHd;
    marks = skinMarks;
    gl_Position = projectionFromWo * place;
}
