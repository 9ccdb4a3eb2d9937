// A lock that a running window holds, and that frees itself when its process dies.
#pragma once

#include "model/disk/own_folder.h"

#include <memory>

class QLockFile;

namespace hairpaint::model {

/// A file that names the process and is also locked by the system where possible. So it depends neither on the clock
/// nor on reused process ids, and a process with read access can check it. One thread at a time.
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

    /// Never waits. If Missing, other processes on this machine still find it held if the file existed.
    [[nodiscard]] State take();
    void release();
    /// The state that take() would find, without taking the lock.
    [[nodiscard]] bool isHeld();

private:
    const OwnFolder& m_folder;
    QString m_name;
    int m_descriptor = -1;
    bool m_isTaken = false;
    std::unique_ptr<QLockFile> m_file; ///< Where there are no descriptors.
};

} // namespace hairpaint::model
