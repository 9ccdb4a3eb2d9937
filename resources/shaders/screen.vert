// One triangle over the whole target, with the background's gradient as sRGB.
out vec3 backgroundSrgb;

void main()
{
    float y = gl_VertexID == 2 ? 3.0 : -1.0;
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, y, 0.0, 1.0);
    // The middle of the picture has exactly the colour that was asked for.
    backgroundSrgb = background[0].rgb + y * background[1].rgb;
}
