// The editor's side of hairpaint-import: foreign images and meshes, decoded in another process.
#pragma once

#include "model/files/project_file.h"
#include "model/heads/rigged_mesh.h"
#include "model/project/project.h"
#include "model/values/error.h"

#include <optional>

namespace hairpaint::model {

/// 16-bit pixels, row 0 on top. `channels` 1 to 4 (grey, grey and alpha, RGB, RGBA), unassociated.
struct ForeignImage
{
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint16_t> pixels;
    bool areColours = false; ///< sRGB; else numbers, which are kept as they are.
};

/// What holds the helper while it decodes foreign files.
struct HelperSandbox
{
    int landlockVersion = 0; ///< 0: which files it opens is not confined.
    bool filtersCalls = false;
    int mostMegabytes = 0; ///< Of memory; 0: without a bound of its own.
};

/// Runs the helper program beside this one (or `HAIRPAINT_IMPORT`, for tests). Each call waits at most `timeoutMs`,
/// polls `progress` for cancelling, and bounds the helper's memory. A helper that crashes, hangs or answers nonsense is
/// an Error naming the file. Any thread.
class ImporterClient
{
public:
    explicit ImporterClient(QString helperPath = {}, int timeoutMs = usualTimeoutMs());
    /// 16 s, or `HAIRPAINT_IMPORT_MS`, for tests.
    [[nodiscard]] static int usualTimeoutMs();

    /// Its numbers as they are.
    [[nodiscard]] Result<ForeignImage> readImage(const QString& path, const Progress& progress = {}) const;
    /// As sRGB, whatever light (EXR, HDR) or profile the file has them in.
    [[nodiscard]] Result<ForeignImage> readColours(const QString& path, const Progress& progress = {}) const;
    /// PNG, TIFF, EXR, ... by the file's ending; 8 or 16 bits a channel. Colours become linear light in EXR.
    [[nodiscard]] Result<void> writeImage(const ForeignImage& image, const QString& path, int bits = 16,
                                          const Progress& progress = {}) const;
    [[nodiscard]] Result<RiggedMesh> readMesh(const QString& path, const Progress& progress = {}) const;
    /// As the helper finds it on this machine, tried there; none where it gives no answer.
    [[nodiscard]] std::optional<HelperSandbox> sandbox() const;

private:
    [[nodiscard]] Result<ForeignImage> decodeImage(const QString& path, bool areColours,
                                                   const Progress& progress) const;
    [[nodiscard]] Result<RiggedMesh> decodeMesh(const QString& path, const Progress& progress) const;
    [[nodiscard]] Result<void> encodeImage(const ForeignImage& image, const QString& path, int bits,
                                           const Progress& progress) const;

    QString m_helperPath;
    int m_timeoutMs;
};

} // namespace hairpaint::model
