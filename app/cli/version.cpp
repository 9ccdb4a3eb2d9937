// The version, the libraries, and the helper's sandbox in words.
#include "app/cli/version.h"

#include "app/cli/command.h"
#include "app/session/libraries.h"
#include "model/files/importer_client.h"

#include <QLocale>

namespace hairpaint::app {

namespace {

QStringList sandboxLines(const model::HelperSandbox& sandbox)
{
    constexpr qint64 kBytesPerMegabyte = 1'000'000;
    return {CommandLine::tr("What holds the helper that decodes foreign files, hairpaint-import, on this machine:"),
            sandbox.landlockVersion > 0 ? CommandLine::tr("  files: Landlock, version %1").arg(sandbox.landlockVersion)
                                        : CommandLine::tr("  files: nothing, it may open those that you may"),
            sandbox.filtersCalls ? CommandLine::tr("  system calls: seccomp, by a list of those that are allowed")
                                 : CommandLine::tr("  system calls: nothing, all can be made"),
            sandbox.mostMegabytes > 0 ? CommandLine::tr("  memory: at most %1")
                                            .arg(QLocale().formattedDataSize(sandbox.mostMegabytes * kBytesPerMegabyte,
                                                                             1, QLocale::DataSizeSIFormat))
                                      : CommandLine::tr("  memory: nothing, it may take what there is")};
}

} // namespace

QStringList versionLines()
{
    QStringList lines{QStringLiteral("Hair Paint %1").arg(QCoreApplication::applicationVersion()),
                      CommandLine::tr("Built with %1").arg(librariesInUse().join(QStringLiteral(", ")))};
    if (const std::optional<model::HelperSandbox> sandbox = model::ImporterClient().sandbox())
        lines += sandboxLines(*sandbox);
    else
        lines +=
            CommandLine::tr("The helper that decodes foreign files, hairpaint-import, does not answer; install Hair "
                            "Paint again.");
    return lines;
}

} // namespace hairpaint::app
