// Exceptions as sentences.
#include "model/values/guarded.h"

#include <QCoreApplication>

namespace hairpaint::model {

Error memoryError(const QString& doing)
{
    return {QCoreApplication::translate("Guarded", "%1: there is not enough memory for it; close other programs, or "
                                                   "take something smaller.")
                .arg(doing)};
}

Error thrownError(const QString& doing, const std::exception& thrown)
{
    return {QCoreApplication::translate("Guarded", "%1 failed: %2; try again, and report it where it fails again.")
                .arg(doing, QString::fromLocal8Bit(thrown.what()).simplified())};
}

} // namespace hairpaint::model
