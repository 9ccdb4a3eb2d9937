// The files that Assimp's importers open: ordinary ones alone.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <string>

namespace hairpaint::importer {

/// A model may name other files, its materials and buffers; a pipe or a device among them would be waited for for ever,
/// and is as if it were not there.
class PlainFiles : public Assimp::DefaultIOSystem
{
public:
    /// Assimp takes a file's format by its ending: one of a name with this added is that file.
    static constexpr const char* kOtherEnding = "|.glb";
    [[nodiscard]] bool Exists(const char* file) const override;
    Assimp::IOStream* Open(const char* file, const char* mode) override;
    /// The last one that was to be opened and is not there, without its folders; empty where there is none.
    [[nodiscard]] const std::string& missing() const { return m_missing; }

private:
    std::string m_missing;
};

} // namespace hairpaint::importer
