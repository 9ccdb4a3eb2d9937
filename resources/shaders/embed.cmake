# Writes OUTPUT, a C++ file that holds the texts of the SHADERS (a list of paths) as raw strings, and as
# "constants.glsl" the floats that the C++ header CONSTANTS defines. Instead of a line #include "FORMULA" of a shader, for each
# of the FORMULAS (paths from the sources' root), stands the text of that file.
# Run as: cmake -DOUTPUT=... -DROOT=... "-DSHADERS=a;b" -DCONSTANTS=a.h "-DFORMULAS=a.inl;b.inl" -P embed.cmake
set(text "// Generated from resources/shaders.\n#include \"view/rendering/gl/shader_sources.h\"\n\n")
string(APPEND text "namespace hairpaint::rendering {\n\nstd::string_view shaderSource(std::string_view name)\n{\n")
foreach(path IN LISTS SHADERS)
    get_filename_component(name "${path}" NAME)
    file(READ "${path}" source)
    foreach(formula IN LISTS FORMULAS)
        file(READ "${ROOT}/${formula}" text_of_formula)
        string(REPLACE "#include \"${formula}\"" "${text_of_formula}" source "${source}")
    endforeach()
    string(APPEND text "    if (name == \"${name}\")\n        return R\"glsl(${source})glsl\";\n")
endforeach()
file(STRINGS "${CONSTANTS}" lines REGEX "^inline constexpr float k[A-Za-z]+ = [0-9.]+F;$")
string(APPEND text "    if (name == \"constants.glsl\")\n        return R\"glsl(")
foreach(line IN LISTS lines)
    string(REGEX REPLACE "^inline constexpr float (k[A-Za-z]+) = ([0-9.]+)F;$" "const float \\1 = \\2;" line "${line}")
    string(APPEND text "${line}\n")
endforeach()
string(APPEND text ")glsl\";\n")
string(APPEND text "    return {};\n}\n\n} // namespace hairpaint::rendering\n")
file(WRITE "${OUTPUT}" "${text}")
