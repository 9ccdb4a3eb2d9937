// Ordinary files and others, inside and outside.
#include "app/importer/model_folder.h"

#include <algorithm>
#include <fstream>
#include <system_error>

namespace hairpaint::importer {

namespace {

std::filesystem::path fromUtf8(const std::string& file)
{
    return reinterpret_cast<const char8_t*>(file.c_str());
}

std::string toUtf8(const std::filesystem::path& path)
{
    const std::u8string name = path.u8string();
    return {name.begin(), name.end()};
}

} // namespace

ModelFolder::ModelFolder(const std::string& model) : m_model(model), m_named(fromUtf8(model).parent_path())
{
    std::error_code problem;
    m_folder = std::filesystem::canonical(m_named.empty() ? "." : m_named, problem);
}

bool ModelFolder::mayBeRead(const std::string& file) const
{
    if (file == m_model)
        return true;
    std::error_code problem;
    const std::filesystem::path real = std::filesystem::weakly_canonical(fromUtf8(file), problem);
    // What can't be told is left to the sandbox.
    return problem || m_folder.empty() || std::ranges::mismatch(m_folder, real).in1 == m_folder.end();
}

std::string ModelFolder::pathOf(const std::string& name) const
{
    return toUtf8(m_named / fromUtf8(name));
}

bool ModelFolder::isOrdinary(const std::string& file)
{
    std::error_code problem;
    return std::filesystem::is_regular_file(fromUtf8(file), problem);
}

std::string ModelFolder::nameOf(const std::string& file)
{
    return toUtf8(fromUtf8(file).filename());
}

tl::expected<std::vector<std::byte>, wire::Refusal> bytesOfFile(const std::string& path)
{
    constexpr std::uintmax_t kMostFileBytes = 1U << 30U;
    const std::filesystem::path file = fromUtf8(path);
    std::error_code problem;
    const std::uintmax_t size = std::filesystem::file_size(file, problem);
    std::ifstream stream(file, std::ios::binary);
    if (problem || !stream)
        return tl::unexpected(wire::Reason::CannotOpen);
    if (size > kMostFileBytes)
        return tl::unexpected(wire::Reason::TooLarge);
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!stream && !bytes.empty())
        return tl::unexpected(wire::Reason::CannotOpen);
    return bytes;
}

} // namespace hairpaint::importer
