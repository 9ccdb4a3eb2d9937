// OpenGL names, buffers, textures and programs.
#include "view/rendering/gl/gl_objects.h"

#include "view/rendering/gl/shader_sources.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace hairpaint::rendering {

void deleteBuffer(unsigned id)
{
    glDeleteBuffers(1, &id);
}

void deleteTexture(unsigned id)
{
    glDeleteTextures(1, &id);
}

void deleteProgram(unsigned id)
{
    glDeleteProgram(id);
}

void deleteFramebuffer(unsigned id)
{
    glDeleteFramebuffers(1, &id);
}

void deleteQuery(unsigned id)
{
    glDeleteQueries(1, &id);
}

void deleteVertexArray(unsigned id)
{
    glDeleteVertexArrays(1, &id);
}

Framebuffer makeFramebuffer()
{
    unsigned id = 0;
    glGenFramebuffers(1, &id);
    return Framebuffer(id);
}

VertexArray makeVertexArray()
{
    unsigned id = 0;
    glGenVertexArrays(1, &id);
    return VertexArray(id);
}

bool Buffer::reserve(std::size_t bytes)
{
    constexpr std::size_t kLargeBytes = 4U << 20U;
    constexpr std::size_t kManyTimes = 4; // So that hair that moves and stands still by turns does not allocate.
    bytes = std::max<std::size_t>(bytes, 16);
    const bool isTooLarge = m_capacity > std::max(kLargeBytes, kManyTimes * bytes);
    if (bytes <= m_capacity && !isTooLarge)
        return false;
    // Some room to grow, so that a stroke that adds hair does not allocate every frame.
    const std::size_t wanted = m_capacity == 0 || isTooLarge ? bytes : bytes + bytes / 4;
    m_capacity = 0;
    unsigned id = 0;
    glGenBuffers(1, &id);
    m_name = GlName<deleteBuffer>(id);
    glBindBuffer(GL_COPY_WRITE_BUFFER, id);
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(wanted), nullptr, GL_DYNAMIC_DRAW);
    // Asked for instead of glGetError, which would take the error away from whoever draws.
    GLint64 given = 0;
    glGetBufferParameteri64v(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &given);
    if (given >= static_cast<GLint64>(wanted))
        m_capacity = wanted;
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return true;
}

void Buffer::assign(const void* data, std::size_t bytes)
{
    reserve(bytes);
    write(0, data, bytes);
}

void Buffer::write(std::size_t offset, const void* data, std::size_t bytes)
{
    if (bytes == 0)
        return;
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_name.id());
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

std::size_t Buffer::writeChanged(const void* data, std::size_t bytes, const void* before, std::size_t bytesBefore)
{
    constexpr std::size_t kBlock = 16U << 10U;
    if (bytes > m_capacity || bytesBefore != bytes || before == nullptr) {
        assign(data, bytes);
        return bytes;
    }
    const auto* now = static_cast<const std::byte*>(data);
    const auto* was = static_cast<const std::byte*>(before);
    std::size_t written = 0;
    std::size_t from = 0; // Begin of the run of blocks that differ.
    for (std::size_t at = 0; at < bytes; at += kBlock) {
        const std::size_t length = std::min(kBlock, bytes - at);
        if (std::memcmp(now + at, was + at, length) != 0)
            continue;
        write(from, now + from, at - from);
        written += at - from;
        from = at + length;
    }
    write(from, now + from, bytes - from);
    return written + (bytes - from);
}

void Buffer::read(void* data, std::size_t bytes) const
{
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_COPY_READ_BUFFER, m_name.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(bytes), data);
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
}

std::size_t mostBytesOfABuffer()
{
    constexpr GLint64 kLeast = 1 << 24; // The least size that OpenGL guarantees.
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return static_cast<std::size_t>(std::max(bytes, kLeast));
}

void Buffer::clear()
{
    if (m_capacity == 0)
        return;
    glBindBuffer(GL_COPY_WRITE_BUFFER, m_name.id());
    const std::uint32_t zero = 0;
    glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
    glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

void Buffer::bindStorage(unsigned index) const
{
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, m_name.id());
}

void Buffer::bindUniform(unsigned index) const
{
    glBindBufferBase(GL_UNIFORM_BUFFER, index, m_name.id());
}

void Texture::resize2D(unsigned internalFormat, int width, int height, bool smooth)
{
    make(GL_TEXTURE_2D, internalFormat, {width, height, 1}, smooth);
}

void Texture::resize3D(unsigned internalFormat, int side)
{
    make(GL_TEXTURE_3D, internalFormat, {side, side, side}, true);
}

void Texture::make(unsigned target, unsigned internalFormat, glm::ivec3 size, bool smooth)
{
    if (m_format == internalFormat && m_size == size)
        return;
    m_target = target;
    m_format = internalFormat;
    m_size = size;
    unsigned id = 0;
    glGenTextures(1, &id);
    m_name = GlName<deleteTexture>(id);
    glBindTexture(target, id);
    const int filter = smooth ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
    // Beside an opacity grid there is no hair: its outermost columns must not reach on as stripes of shade. Behind it
    // the last layer's sum goes on.
    const int beside = target == GL_TEXTURE_3D ? GL_CLAMP_TO_BORDER : GL_CLAMP_TO_EDGE;
    glTexParameteri(target, GL_TEXTURE_WRAP_S, beside);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, beside);
    glTexParameteri(target, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
    if (target == GL_TEXTURE_3D)
        glTexStorage3D(target, 1, internalFormat, size.x, size.y, size.z);
    else
        glTexStorage2D(target, 1, internalFormat, size.x, size.y);
    glBindTexture(target, 0);
}

void Texture::bind(unsigned unit) const
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(m_target, m_name.id());
}

tl::expected<Program, std::string> Program::compute(std::string_view shader)
{
    return link({{GL_COMPUTE_SHADER, shader}}, {});
}

tl::expected<Program, std::string> Program::graphics(std::string_view vertex, std::string_view fragment,
                                                     std::string_view defines)
{
    return link({{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}, defines);
}

tl::expected<Program, std::string> Program::link(std::initializer_list<Stage> stages, std::string_view defines)
{
    Program program;
    program.m_name = GlName<deleteProgram>(glCreateProgram());
    const unsigned id = program.m_name.id();
    std::array<char, 1024> log{};
    for (const Stage& stage : stages) {
        const unsigned shader = glCreateShader(stage.kind);
        const std::array<std::string_view, 9> parts{
            "#version 430 core\n",           defines,
            shaderSource("constants.glsl"),  shaderSource("strand_layout.glsl"),
            shaderSource("common.glsl"),     shaderSource("environment.glsl"),
            shaderSource("hair_light.glsl"), shaderSource("projected_point.glsl"),
            shaderSource(stage.file)};
        std::array<const char*, parts.size()> texts{};
        std::array<int, parts.size()> lengths{};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            texts[i] = parts[i].empty() ? "" : parts[i].data();
            lengths[i] = static_cast<int>(parts[i].size());
        }
        glShaderSource(shader, static_cast<int>(parts.size()), texts.data(), lengths.data());
        glCompileShader(shader);
        int done = 0;
        glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
        if (done == 0)
            glGetShaderInfoLog(shader, static_cast<int>(log.size()), nullptr, log.data());
        else
            glAttachShader(id, shader);
        glDeleteShader(shader);
        if (done == 0)
            return tl::unexpected("The shader " + std::string(stage.file) + " does not compile: " + log.data());
    }
    glLinkProgram(id);
    int done = 0;
    glGetProgramiv(id, GL_LINK_STATUS, &done);
    if (done == 0) {
        glGetProgramInfoLog(id, static_cast<int>(log.size()), nullptr, log.data());
        return tl::unexpected("The shader " + std::string(stages.begin()->file) + " does not link: " + log.data());
    }
    return program;
}

void Program::use() const
{
    glUseProgram(m_name.id());
}

void Program::set(const char* name, int value) const
{
    glUniform1i(glGetUniformLocation(m_name.id(), name), value);
}

void Program::set(const char* name, unsigned value) const
{
    glUniform1ui(glGetUniformLocation(m_name.id(), name), value);
}

void Program::set(const char* name, float value) const
{
    glUniform1f(glGetUniformLocation(m_name.id(), name), value);
}

void Program::set(const char* name, glm::vec2 value) const
{
    glUniform2f(glGetUniformLocation(m_name.id(), name), value.x, value.y);
}

void Program::set(const char* name, glm::ivec2 value) const
{
    glUniform2i(glGetUniformLocation(m_name.id(), name), value.x, value.y);
}

void Program::set(const char* name, const glm::vec4& value) const
{
    glUniform4f(glGetUniformLocation(m_name.id(), name), value.x, value.y, value.z, value.w);
}

} // namespace hairpaint::rendering
