// Exceptions as sentences.
#include "model/guarded.h"

#include <QCoreApplication>

#include <new>

namespace hairpaint::model {

Error caughtError(const QString& doing)
{
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return {QCoreApplication::translate("Guarded",
                                            "%1: there is not enough memory for it; close other programs, or "
                                            "take something smaller.")
                    .arg(doing)};
    } catch (const std::exception& other) {
        return {QCoreApplication::translate("Guarded", "%1 failed: %2.")
                    .arg(doing, QString::fromLocal8Bit(other.what()).simplified())};
    }
}

} // namespace hairpaint::model
