// Assets between @, prims between < and >.
#include "model/importing/usd_layers.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <utility>

namespace hairpaint::model {

std::vector<UsdReference> readReferences(UsdScanner& scanner)
{
    std::vector<UsdReference> references;
    const bool isList = scanner.accept('[');
    do {
        UsdReference reference;
        if (scanner.peek() == '@') {
            const std::string_view asset = scanner.asset();
            reference.asset = QString::fromUtf8(asset.data(), static_cast<qsizetype>(asset.size()));
        }
        if (scanner.peek() == '<')
            reference.prim = scanner.path();
        if (!reference.asset.isEmpty() || !reference.prim.empty())
            references.push_back(std::move(reference));
        else if (scanner.peek() != ']')
            scanner.skipValue();             // None.
        if (isList && scanner.peek() == '(') // Offset and scale of time.
            scanner.skipValue();
        (void)scanner.accept(',');
    } while (isList && !scanner.accept(']') && !scanner.isBroken());
    return references;
}

UsdOpener usdFilesBeside(const QString& path)
{
    return [path](const QString& asset, const QString& from) -> std::optional<UsdLayer> {
        constexpr qint64 kMostBytes = qint64{1} << 30;
        const QString folder = QFileInfo(path).canonicalPath() + QLatin1Char('/');
        const QFileInfo named(QFileInfo(from.isEmpty() ? path : from).dir().filePath(asset));
        const QString target = named.canonicalFilePath(); // Links resolved; empty where there is none.
        QFile file(target);
        if (!target.startsWith(folder) || !named.isFile() || named.size() > kMostBytes ||
            !file.open(QIODevice::ReadOnly))
            return std::nullopt;
        UsdLayer layer{.text = file.readAll(), .path = target};
        return layer.text.startsWith("#usda ") ? std::optional(std::move(layer)) : std::nullopt;
    };
}

} // namespace hairpaint::model
