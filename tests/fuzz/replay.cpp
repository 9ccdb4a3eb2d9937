// Runs a target over every file of a folder, as an ordinary test: what fuzzing once found stays mended.
#include "tests/fuzz/fuzz_input.h"

#include <QDir>

#include <cstdio>

int main(int argc, char** argv)
{
    const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QString());
    const QStringList names = folder.entryList(QDir::Files, QDir::Name);
    for (const QString& name : names) {
        std::printf("%s\n", qPrintable(name));
        std::fflush(stdout); // The last name is the one that failed.
        QFile file(folder.filePath(name));
        if (!file.open(QIODevice::ReadOnly))
            return 1;
        const QByteArray bytes = file.readAll();
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                               static_cast<std::size_t>(bytes.size()));
    }
    std::printf("Totals: %d passed, 0 failed, 0 skipped, 0 blacklisted\n", static_cast<int>(names.size()));
    return names.isEmpty() ? 1 : 0;
}
