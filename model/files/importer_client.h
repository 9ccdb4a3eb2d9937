// The editor's side of hairpaint-import: foreign images and meshes, decoded in another process.
#pragma once

#include "model/files/project_file.h"
#include "model/heads/rigged_mesh.h"
#include "model/project/project.h"
#include "model/values/error.h"

#include <memory>
#include <optional>

namespace hairpaint::model {

class HelperRun;

/// 16-bit pixels, row 0 on top. `channels` 1 to 4 (grey, grey and alpha, RGB, RGBA), unassociated.
struct ForeignImage
{
    int width = 0, height = 0, channels = 0;
    std::vector<std::uint16_t> pixels;
    bool areColours = false; ///< Whether the pixels are colours in sRGB; else they are numbers, kept as they are.
};

/// What holds the helper while it decodes foreign files.
struct HelperSandbox
{
    int landlockVersion = 0; ///< Version of Landlock in use; 0: the files that it may open are not restricted.
    bool filtersCalls = false;
    int mostMegabytes = 0; ///< Limit on the helper's memory, MB; 0: it has none of its own.
};

/// Runs the helper program beside this one (or `HAIRPAINT_IMPORT`, for tests). Each call waits at most `timeoutMs`,
/// polls `progress` for cancelling, and bounds the helper's memory. A helper that crashes, hangs or answers nonsense is
/// an Error naming the file. Its start takes a third of a second, and later calls of the same client do without: keep
/// one where there are several files. Any thread, but the same for all calls.
class ImporterClient
{
public:
    explicit ImporterClient(const QString& helperPath = {}, int timeoutMs = usualTimeoutMs());
    ~ImporterClient();
    ImporterClient(const ImporterClient&) = delete;
    ImporterClient& operator=(const ImporterClient&) = delete;
    /// 16 s, or `HAIRPAINT_IMPORT_MS`, for tests.
    [[nodiscard]] static int usualTimeoutMs();

    /// Reads an image's numbers as they are stored.
    [[nodiscard]] Result<ForeignImage> readImage(const QString& path, const Progress& progress = {});
    /// Reads an image's colours as sRGB, whatever light (EXR, HDR) or profile the file has them in.
    [[nodiscard]] Result<ForeignImage> readColours(const QString& path, const Progress& progress = {});
    /// PNG, TIFF, EXR, ... by the file's ending; 8 or 16 bits a channel. Colours become linear light in EXR.
    [[nodiscard]] Result<void> writeImage(const ForeignImage& image, const QString& path, int bits = 16,
                                          const Progress& progress = {});
    [[nodiscard]] Result<RiggedMesh> readMesh(const QString& path, const Progress& progress = {});
    /// The same of a mesh that nobody paints on, with or without uvs.
    [[nodiscard]] Result<RiggedMesh> readBody(const QString& path, const Progress& progress = {});
    /// The sandbox as the helper sets it up on this machine; none where the helper gives no answer.
    [[nodiscard]] std::optional<HelperSandbox> sandbox();

private:
    [[nodiscard]] Result<ForeignImage> decodeImage(const QString& path, bool areColours, const Progress& progress);
    [[nodiscard]] Result<RiggedMesh> decodeMesh(const QString& path, bool needsUvs, const Progress& progress);
    [[nodiscard]] Result<void> encodeImageFile(const ForeignImage& image, const QString& path, int bits,
                                               const Progress& progress);

    std::unique_ptr<HelperRun> m_helper;
};

} // namespace hairpaint::model
