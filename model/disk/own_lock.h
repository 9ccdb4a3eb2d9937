// A lock that a running window holds, and that frees itself when its process dies.
#pragma once

#include "model/disk/own_folder.h"

#include <memory>

class QLockFile;

namespace hairpaint::model {

/// A file that names the process, held by the system too where it can: so neither the clock nor another process that
/// got the same number matters, and who may only read can tell all the same. One thread at a time.
class OwnLock
{
public:
    enum class State
    {
        Taken,
        Held,    ///< By a window that lives, or that can't be asked, since it runs on another machine.
        Missing, ///< Nobody holds it, but it can't be taken: nothing can be written there.
    };
    /// `folder` outlives it.
    OwnLock(const OwnFolder& folder, QString name);
    ~OwnLock(); ///< Releases it.
    OwnLock(const OwnLock&) = delete;
    OwnLock& operator=(const OwnLock&) = delete;

    /// Waits for nobody. Where it is Missing, others on this machine still find it held if there was such a file.
    [[nodiscard]] State take();
    void release();
    /// What take() would find, to be asked by who does not want it.
    [[nodiscard]] bool isHeld();

private:
    const OwnFolder& m_folder;
    QString m_name;
    int m_descriptor = -1;
    bool m_isTaken = false;
    std::unique_ptr<QLockFile> m_file; ///< Where there are no descriptors.
};

} // namespace hairpaint::model
