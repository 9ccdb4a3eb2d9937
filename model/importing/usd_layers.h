// What a layer of USD names of others, and where these are read from.
#pragma once

#include "model/importing/usd_scanner.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace hairpaint::model {

struct UsdReference
{
    QString asset;    ///< As it is written; empty: the layer itself.
    std::string prim; ///< "/Hair/Locks"; empty: the layer's default prim.

    friend bool operator==(const UsdReference&, const UsdReference&) = default;
};
/// One, or a list; what else stands there is passed over.
[[nodiscard]] std::vector<UsdReference> readReferences(UsdScanner& scanner);

struct UsdLayer
{
    QByteArray text;
    QString path; ///< As the opener knows it.
};
/// Opens the text that the layer at `from` names; `from` is empty for the first one. None where it can't be read, is no
/// text, or lies where nothing is to be read.
using UsdOpener = std::function<std::optional<UsdLayer>(const QString& asset, const QString& from)>;

/// Files in the folder of this one and below.
[[nodiscard]] UsdOpener usdFilesBeside(const QString& path);

} // namespace hairpaint::model
