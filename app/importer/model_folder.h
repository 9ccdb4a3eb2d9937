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
    /// Of a name that is relative to the folder, or whole.
    [[nodiscard]] std::string pathOf(const std::string& name) const;

    [[nodiscard]] static bool isOrdinary(const std::string& file);
    /// Without its folders.
    [[nodiscard]] static std::string nameOf(const std::string& file);

private:
    std::string m_model;
    std::filesystem::path m_named;  ///< The folder as the model's path has it.
    std::filesystem::path m_folder; ///< Without links; empty where that can't be told.
};

/// Of an ordinary file, at most 1 GiB; UTF-8.
[[nodiscard]] tl::expected<std::vector<std::byte>, wire::Refusal> bytesOfFile(const std::string& path);

} // namespace hairpaint::importer
