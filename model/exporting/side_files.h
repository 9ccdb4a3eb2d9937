// Files that lie beside the one that names them, and appear with it or not at all.
#pragma once

#include "model/values/error.h"

#include <QByteArray>
#include <QString>

#include <functional>
#include <vector>

namespace hairpaint::model {

struct SideFile
{
    QString path; ///< In the folder of the file that names it.
    QByteArray bytes;
};

/// Has `write` fill the file `staged` that becomes `path`, and writes those beside it; they take their names once all
/// are whole, and nothing is written where one of them can't be. Any thread. Errors: name the file that is in the way.
[[nodiscard]] Result<void> writeWithSideFiles(const QString& path, const std::vector<SideFile>& sides,
                                              const std::function<Result<void>(const QString& staged)>& write);

} // namespace hairpaint::model
