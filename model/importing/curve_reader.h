// The table of formats that hair is read from.
#pragma once

#include "model/importing/foreign_curves.h"
#include "model/values/error.h"
#include "model/values/progress.h"

#include <QString>
#include <QStringList>

namespace hairpaint::model {

/// Their endings, without the dot: "hair".
[[nodiscard]] const QStringList& curveFileEndings();

/// By the name's ending. Fails where the file can't be read, holds no strand, or `progress` cancels. Any thread.
[[nodiscard]] Result<ForeignCurves> readCurves(const QString& path, const Progress& progress = {});

/// What every format's curves go through: strands of one point, or with a point that is no number or further than any
/// hair, are taken out and counted in `leftOut`. Groups that are left without strands are taken out, too.
void leaveOutBroken(ForeignCurves& curves);

} // namespace hairpaint::model
