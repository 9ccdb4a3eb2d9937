// Owners of OpenGL names, which delete them. The context they were made in must be current whenever they are used or
// die.
#pragma once

#include <glm/glm.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace hairpaint::rendering {

/// A name that is deleted by `Deleter` unless it is 0.
template<void (*Deleter)(unsigned)>
class GlName
{
public:
    GlName() = default;
    explicit GlName(unsigned id) : m_id(id) {}
    GlName(GlName&& other) noexcept : m_id(std::exchange(other.m_id, 0U)) {}
    GlName& operator=(GlName&& other) noexcept
    {
        std::swap(m_id, other.m_id);
        return *this;
    }
    GlName(const GlName&) = delete;
    GlName& operator=(const GlName&) = delete;
    ~GlName()
    {
        if (m_id != 0)
            Deleter(m_id);
    }
    [[nodiscard]] unsigned id() const { return m_id; }

private:
    unsigned m_id = 0;
};

void deleteBuffer(unsigned id);
void deleteTexture(unsigned id);
void deleteProgram(unsigned id);
void deleteFramebuffer(unsigned id);
void deleteVertexArray(unsigned id);
void deleteQuery(unsigned id);

using Framebuffer = GlName<deleteFramebuffer>;
using VertexArray = GlName<deleteVertexArray>;
[[nodiscard]] Framebuffer makeFramebuffer();
[[nodiscard]] VertexArray makeVertexArray();

/// A buffer of the requested size, or some times larger.
class Buffer
{
public:
    /// Makes room for `bytes`; true where it was made anew, and what it held is lost: it was too small, or large for
    /// nothing. At least 16 bytes, so that it can always be bound. Where OpenGL has no memory its capacity is 0, and
    /// the next call tries again.
    bool reserve(std::size_t bytes);
    /// Reserves at least `bytes` and writes them.
    void assign(const void* data, std::size_t bytes);
    void write(std::size_t offset, const void* data, std::size_t bytes);
    /// Writes the blocks of `data` that differ from `before`, which the buffer holds; all of it where that has another
    /// length. Returns the bytes written.
    std::size_t writeChanged(const void* data, std::size_t bytes, const void* before, std::size_t bytesBefore);
    /// Waits for the GPU.
    void read(void* data, std::size_t bytes) const;
    /// Fills it with zeros.
    void clear();
    void bindStorage(unsigned index) const;
    void bindUniform(unsigned index) const;
    [[nodiscard]] unsigned id() const { return m_name.id(); }
    [[nodiscard]] std::size_t capacity() const { return m_capacity; }

private:
    GlName<deleteBuffer> m_name;
    std::size_t m_capacity = 0;
};

/// Greatest size of a buffer that shaders read or write, bytes.
[[nodiscard]] std::size_t mostBytesOfABuffer();

/// A texture without mipmaps, made anew when its size or format differs.
class Texture
{
public:
    /// `smooth`: sampled bilinearly.
    void resize2D(unsigned internalFormat, int width, int height, bool smooth = false);
    void resize3D(unsigned internalFormat, int side);
    void bind(unsigned unit) const;
    [[nodiscard]] unsigned id() const { return m_name.id(); }

private:
    void make(unsigned target, unsigned internalFormat, glm::ivec3 size, bool smooth);
    GlName<deleteTexture> m_name;
    unsigned m_target = 0;
    unsigned m_format = 0;
    glm::ivec3 m_size{0};
};

/// A linked program. Uniforms are set by name; a name that the shader does not have is ignored.
class Program
{
public:
    /// Names of files in resources/shaders; the files that all share and the version line come before each.
    [[nodiscard]] static tl::expected<Program, std::string> compute(std::string_view shader);
    /// `defines`: lines of preprocessor that come before the shaders.
    [[nodiscard]] static tl::expected<Program, std::string> graphics(std::string_view vertex, std::string_view fragment,
                                                                     std::string_view defines = {});

    void use() const;
    void set(const char* name, int value) const;
    void set(const char* name, unsigned value) const;
    void set(const char* name, float value) const;
    void set(const char* name, glm::vec2 value) const;
    void set(const char* name, glm::ivec2 value) const;
    void set(const char* name, const glm::vec4& value) const;

private:
    struct Stage
    {
        unsigned kind;
        std::string_view file;
    };
    [[nodiscard]] static tl::expected<Program, std::string> link(std::initializer_list<Stage> stages,
                                                                 std::string_view defines);
    GlName<deleteProgram> m_name;
};

} // namespace hairpaint::rendering
