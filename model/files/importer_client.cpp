// Requests to hairpaint-import and what its answers mean.
#include "model/files/importer_client.h"

#include "model/disk/atomic_file.h"
#include "model/files/helper_process.h"
#include "model/files/wire_format.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace hairpaint::model {

namespace {

constexpr qint64 kMostForeignBytes = qint64{2} << 30;
const QString kProgramName = QStringLiteral("hairpaint-import");

/// Beside the program as it is built, and on Windows; else in the folder for programs that nobody starts by hand.
QString findHelper()
{
    const QString fromEnvironment = qEnvironmentVariable("HAIRPAINT_IMPORT");
    if (!fromEnvironment.isEmpty())
        return fromEnvironment;
    const QDir folder(QCoreApplication::applicationDirPath());
#ifdef Q_OS_WIN
    return folder.filePath(kProgramName + QStringLiteral(".exe"));
#else
    const QString installed = folder.filePath(QStringLiteral("../libexec/hairpaint/") + kProgramName);
    const QString beside = folder.filePath(kProgramName);
    return !QFileInfo::exists(beside) && QFileInfo::exists(installed) ? QDir::cleanPath(installed) : beside;
#endif
}

QString failureText(HelperFailure failure)
{
    switch (failure) {
    case HelperFailure::NotStarted:
        return say(QT_TRANSLATE_NOOP("Files", "the helper program hairpaint-import could not be started; install Hair "
                                              "Paint again"));
    case HelperFailure::Crashed:
        return say(QT_TRANSLATE_NOOP("Files", "reading it failed, so it is likely damaged; convert it with another "
                                              "program and try again"));
    case HelperFailure::TimedOut:
        return say(QT_TRANSLATE_NOOP("Files", "it took too long; try a smaller or simpler file"));
    case HelperFailure::Nonsense:
        return say(QT_TRANSLATE_NOOP("Files", "the helper program's answer made no sense; convert the file with "
                                              "another program and try again"));
    case HelperFailure::Cancelled:
        break;
    }
    return {};
}

QString reasonText(const wire::Refusal& refusal)
{
    switch (refusal.reason) {
    case wire::Reason::CannotOpen:
        return say(QT_TRANSLATE_NOOP("Files", "it could not be read; check that it is there and may be read"));
    case wire::Reason::UnknownFormat:
        return say(
            QT_TRANSLATE_NOOP("Files", "its format is not known; convert it to PNG (an image) or glTF (a mesh)"));
    case wire::Reason::Damaged:
        return say(QT_TRANSLATE_NOOP("Files", "it is damaged or cut short; try another copy of it"));
    case wire::Reason::TooLarge:
        return say(QT_TRANSLATE_NOOP("Files", "it is too large; try one of at most 8192 x 8192 pixels or 2 million "
                                              "vertices"));
    case wire::Reason::NoTriangles:
        return say(QT_TRANSLATE_NOOP("Files", "it holds no surface; choose a mesh of triangles or polygons"));
    case wire::Reason::NoUvs:
        return say(QT_TRANSLATE_NOOP("Files", "its mesh has no uv coordinates, which the maps need; unwrap it in a 3D "
                                              "program first"));
    case wire::Reason::CannotWriteEnding:
        return say(QT_TRANSLATE_NOOP("Files", "images with this ending can't be written; use .png, .tif or .exr"));
    case wire::Reason::UnknownCompression:
        return say(QT_TRANSLATE_NOOP("Files",
                                     "the way it is compressed is not supported; save it as PNG or TIFF in the "
                                     "program that made it, and try again"));
    case wire::Reason::LayersOnly:
        return say(QT_TRANSLATE_NOOP("Files", "it holds layers without the picture that they make; save it with "
                                              "“Maximize compatibility” on, or as PNG or TIFF, and try again"));
    case wire::Reason::InkColours:
        return say(QT_TRANSLATE_NOOP("Files", "its colours are inks (CMYK), which are read of TIFF and JPEG alone; "
                                              "convert it to RGB, or save it as TIFF, and try again"));
    case wire::Reason::UnreadFormat:
        return say(QT_TRANSLATE_NOOP("Files", "its format, %1, is not read here; save it as PNG or TIFF in the program "
                                              "that made it, and try again"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    case wire::Reason::OutOfMemory:
        return say(QT_TRANSLATE_NOOP("Files", "there was not enough memory for it; try a smaller one"));
    case wire::Reason::MissingFile:
        return say(QT_TRANSLATE_NOOP("Files",
                                     "the file '%1', which it needs, is missing; put it where it was saved with "
                                     "this one, and try again"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    case wire::Reason::OutsideFolder:
        return say(QT_TRANSLATE_NOOP("Files",
                                     "the file '%1', which it needs, lies outside of its folder, where nothing "
                                     "is read; save both into one folder, and try again"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    case wire::Reason::UnknownExtension:
        return say(QT_TRANSLATE_NOOP("Files",
                                     "it asks for the glTF extension '%1', which is not known here; export it without "
                                     "that extension"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    case wire::Reason::UndecodedCompression:
        return say(QT_TRANSLATE_NOOP("Files",
                                     "its %1 compression could not be decoded, so it is likely damaged; export it "
                                     "without compression"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    case wire::Reason::Malformed:
        return say(QT_TRANSLATE_NOOP("Files", "it can't be read (%1); try another copy of it, or export it once more"))
            .arg(shownPath(QString::fromStdString(refusal.detail)));
    }
    return {};
}

/// Asks the helper and returns the body of the wanted answer; everything else as a sentence.
Result<wire::Bytes> ask(HelperRun& helper, const wire::Bytes& request, wire::Kind wanted, const QString& path,
                        const Progress& progress, Phrase phrase)
{
    const auto refused = [&](const QString& text) {
        return phrase(path, Clause{.text = text, .cure = Clause::Cure::OtherFile});
    };
    tl::expected<HelperAnswer, HelperFailure> answer = helper.ask(request, progress);
    if (!answer) {
        if (answer.error() == HelperFailure::Cancelled)
            return cancelled(path);
        return refused(failureText(answer.error()));
    }
    if (answer->kind == wire::Kind::Refusal)
        if (const auto refusal = wire::decodeRefusal(answer->body))
            return refused(reasonText(*refusal));
    if (answer->kind != wanted)
        return refused(failureText(HelperFailure::Nonsense));
    return std::move(answer->body);
}

tl::unexpected<Error> nonsense(const QString& path)
{
    return cannotOpen(path, Clause{.text = failureText(HelperFailure::Nonsense), .cure = Clause::Cure::OtherFile});
}

wire::Bytes readRequest(wire::Kind kind, const QString& path)
{
    return wire::encodeText(kind, path.toUtf8().toStdString());
}

} // namespace

int ImporterClient::usualTimeoutMs()
{
    constexpr int kUsualMs = 16'000;
    const int fromEnvironment = qEnvironmentVariableIntValue("HAIRPAINT_IMPORT_MS");
    return fromEnvironment > 0 ? fromEnvironment : kUsualMs;
}

ImporterClient::ImporterClient(const QString& helperPath, int timeoutMs)
    : m_helper(std::make_unique<HelperRun>(helperPath.isEmpty() ? findHelper() : helperPath, timeoutMs))
{}

ImporterClient::~ImporterClient() = default;

Result<ForeignImage> ImporterClient::readImage(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return decodeImage(path, false, progress); });
}

Result<ForeignImage> ImporterClient::readColours(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return decodeImage(path, true, progress); });
}

Result<RiggedMesh> ImporterClient::readMesh(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return decodeMesh(path, true, progress); });
}

Result<RiggedMesh> ImporterClient::readBody(const QString& path, const Progress& progress)
{
    return withinMemory(path, cannotOpen, [&] { return decodeMesh(path, false, progress); });
}

Result<void> ImporterClient::writeImage(const ForeignImage& image, const QString& path, int bits,
                                        const Progress& progress)
{
    return withinMemory(path, cannotWrite, [&] { return encodeImageFile(image, path, bits, progress); });
}

std::optional<HelperSandbox> ImporterClient::sandbox()
{
    const wire::Bytes request = wire::encodeText(wire::Kind::TellSandbox, ".");
    const tl::expected<HelperAnswer, HelperFailure> answer = m_helper->ask(request, {});
    if (!answer || answer->kind != wire::Kind::Sandbox)
        return std::nullopt;
    const std::optional<wire::Sandbox> told = wire::decodeSandbox(answer->body);
    if (!told)
        return std::nullopt;
    return HelperSandbox{.landlockVersion = static_cast<int>(told->landlockVersion),
                         .filtersCalls = told->filtersCalls != 0,
                         .mostMegabytes = static_cast<int>(told->mostMegabytes)};
}

Result<ForeignImage> ImporterClient::decodeImage(const QString& path, bool areColours, const Progress& progress)
{
    if (Result<void> readable = checkReadable(path, kMostForeignBytes); !readable)
        return tl::unexpected(readable.error());
    Result<wire::Bytes> body =
        ask(*m_helper, readRequest(areColours ? wire::Kind::ReadColours : wire::Kind::ReadImage, path),
            wire::Kind::Image, path, progress, cannotOpen);
    if (!body)
        return tl::unexpected(body.error());
    std::optional<wire::Image> image = wire::decodeImage(*body);
    if (!image)
        return nonsense(path);
    return ForeignImage{.width = static_cast<int>(image->width),
                        .height = static_cast<int>(image->height),
                        .channels = static_cast<int>(image->channels),
                        .pixels = std::move(image->samples),
                        .areColours = areColours};
}

Result<RiggedMesh> ImporterClient::decodeMesh(const QString& path, bool needsUvs, const Progress& progress)
{
    if (Result<void> readable = checkReadable(path, kMostForeignBytes); !readable)
        return tl::unexpected(readable.error());
    Result<wire::Bytes> body = ask(*m_helper, readRequest(needsUvs ? wire::Kind::ReadMesh : wire::Kind::ReadBody, path),
                                   wire::Kind::Mesh, path, progress, cannotOpen);
    if (!body)
        return tl::unexpected(body.error());
    std::optional<RiggedMesh> mesh = wire::decodeMesh(*body);
    if (!mesh)
        return nonsense(path);
    return std::move(*mesh);
}

Result<void> ImporterClient::encodeImageFile(const ForeignImage& image, const QString& path, int bits,
                                             const Progress& progress)
{
    wire::EncodeRequest request{.bits = bits <= 8 ? 8U : 16U,
                                .ending = QFileInfo(path).suffix().toLower().toStdString(),
                                .image = {.width = static_cast<std::uint32_t>(image.width),
                                          .height = static_cast<std::uint32_t>(image.height),
                                          .channels = static_cast<std::uint32_t>(image.channels),
                                          .samples = image.pixels}};
    const auto refused = [&path](wire::Reason reason) { return cannotWrite(path, Clause{.text = reasonText(reason)}); };
    if (request.ending.empty() || request.ending.size() > wire::kLongestEnding)
        return refused(wire::Reason::CannotWriteEnding);
    if (!wire::imageFits(request.image.width, request.image.height, request.image.channels))
        return refused(wire::Reason::TooLarge);
    if (const Checked<void> writable = checkWritable(path); !writable)
        return cannotWrite(path, writable.error());
    Result<wire::Bytes> body = ask(
        *m_helper, wire::encodeRequest(request, image.areColours ? wire::Kind::EncodeColours : wire::Kind::EncodeImage),
        wire::Kind::Encoded, path, progress, cannotWrite);
    if (!body)
        return tl::unexpected(body.error());
    const auto size = static_cast<qsizetype>(body->size());
    return writeWanted(path, {body->data(), size}, progress);
}

} // namespace hairpaint::model
