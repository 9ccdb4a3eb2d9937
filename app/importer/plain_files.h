// The files that Assimp's importers open: ordinary ones alone.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <string>

namespace hairpaint::importer {

/// A model may name other files, its materials and buffers; a pipe or a device among them would be waited for for ever,
/// and is as if it were not there. Those outside of the model's folder, also behind a link in it, are not opened, as
/// the sandbox has it where there is one.
class PlainFiles : public Assimp::DefaultIOSystem
{
public:
    /// Assimp takes a file's format by its ending: one of a name with this added is that file.
    static constexpr const char* kOtherEnding = "|.glb";
    /// `model`: its path, UTF-8.
    explicit PlainFiles(const std::string& model);
    [[nodiscard]] bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    /// The last file that was to be opened and does not exist, without its folders; empty if there is none.
    [[nodiscard]] const std::string& missing() const { return m_missing; }
    /// The same for the last file outside of the folder.
    [[nodiscard]] const std::string& outside() const { return m_outside; }

private:
    [[nodiscard]] bool isInside(const std::string& file) const;
    [[nodiscard]] bool mayBeRead(const std::string& file) const;

    std::string m_model;
    std::filesystem::path m_folder; ///< Without links; empty where that can't be told.
    std::string m_missing;
    mutable std::string m_outside; ///< Assimp asks whether a file is there before it opens it.
};

} // namespace hairpaint::importer
