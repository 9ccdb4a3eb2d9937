// The files that Assimp's importers open: ordinary ones alone.
#pragma once

#include "app/importer/model_folder.h"

#include <assimp/DefaultIOSystem.h>

#include <string>

namespace hairpaint::importer {

/// See ModelFolder.
class PlainFiles : public Assimp::DefaultIOSystem
{
public:
    /// Assimp takes a file's format by its ending: one of a name with this added is that file.
    static constexpr const char* kOtherEnding = "|.glb";
    /// `model`: its path, UTF-8.
    explicit PlainFiles(const std::string& model) : m_folder(model) {}
    [[nodiscard]] bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    /// The last file that was to be opened and does not exist, without its folders; empty if there is none.
    [[nodiscard]] const std::string& missing() const { return m_missing; }
    /// The same for the last file outside of the folder.
    [[nodiscard]] const std::string& outside() const { return m_outside; }

private:
    [[nodiscard]] bool mayBeRead(const std::string& file) const;

    ModelFolder m_folder;
    std::string m_missing;
    mutable std::string m_outside; ///< Assimp asks whether a file is there before it opens it.
};

} // namespace hairpaint::importer
