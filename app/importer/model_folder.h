// The folder that a model lies in, and what may be read there.
#pragma once

#include "model/files/wire_format.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace hairpaint::importer {

/// A model may name other files, its materials and buffers; a pipe or a device among them would be waited for for ever,
/// and is as if it were not there. Those outside of the model's folder, also behind a link in it, are not opened, as
/// the sandbox has it where there is one. Names are UTF-8.
class ModelFolder
{
public:
    explicit ModelFolder(const std::string& model);
    /// The model itself may be a link.
    [[nodiscard]] bool mayBeRead(const std::string& file) const;
    /// The path of a name that is relative to the folder, or absolute.
    [[nodiscard]] std::string pathOf(const std::string& name) const;

    [[nodiscard]] static bool isOrdinary(const std::string& file);
    /// The file's name without folders.
    [[nodiscard]] static std::string nameOf(const std::string& file);

private:
    std::string m_model;
    std::filesystem::path m_named;  ///< The folder as the model's path has it.
    std::filesystem::path m_folder; ///< The folder with all links resolved; empty where they can't be.
};

/// The bytes of an ordinary file of at most 1 GiB; `path`: UTF-8.
[[nodiscard]] tl::expected<std::vector<std::byte>, wire::Refusal> bytesOfFile(const std::string& path);

} // namespace hairpaint::importer
