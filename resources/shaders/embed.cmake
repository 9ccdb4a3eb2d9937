# Writes OUTPUT, a C++ file that holds the texts of the SHADERS (a list of paths) as raw strings.
# Run as: cmake -DOUTPUT=... "-DSHADERS=a;b" -P embed.cmake
set(text "// Generated from resources/shaders.\n#include \"view/rendering/gl/shader_sources.h\"\n\n")
string(APPEND text "namespace hairpaint::rendering {\n\nstd::string_view shaderSource(std::string_view name)\n{\n")
foreach(path IN LISTS SHADERS)
    get_filename_component(name "${path}" NAME)
    file(READ "${path}" source)
    string(APPEND text "    if (name == \"${name}\")\n        return R\"glsl(${source})glsl\";\n")
endforeach()
string(APPEND text "    return {};\n}\n\n} // namespace hairpaint::rendering\n")
file(WRITE "${OUTPUT}" "${text}")
