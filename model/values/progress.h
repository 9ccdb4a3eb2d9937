// Long work: how far it is, whether it goes on, and who runs it.
#pragma once

#include <QString>

#include <functional>

namespace hairpaint::model {

/// Told how far work is, 0..1; false stops it. Called on the thread that works.
using Progress = std::function<bool(double)>;

/// Has work done that may take long, and waits for it: on another thread with a window that shows how far it is, or
/// simply here. `doing` names it. False where the work was cancelled or has failed, which has been told by then.
using RunLong = std::function<bool(const QString& doing, const std::function<void(const Progress&)>& work)>;

inline bool runHere(const QString& /*doing*/, const std::function<void(const Progress&)>& work)
{
    work({});
    return true;
}

} // namespace hairpaint::model
