// Gives freed memory back while somebody works, at moments that nobody notices.
#pragma once

#include "app/background/jobs.h"

#include <QObject>
#include <QTimer>

namespace hairpaint::model {
class Document;
}

namespace hairpaint::app {

/// In the background, a few seconds after the last change of the document, and during a long run of changes twice a
/// minute; not at all while nothing changes. Outlives neither of the two. GUI thread.
class FreedMemory : public QObject
{
    Q_OBJECT
public:
    FreedMemory(const model::Document& document, Jobs& jobs, QObject* parent = nullptr);

private:
    void onChanged();
    void giveBack();

    Jobs& m_jobs;
    QTimer m_rested;
    QTimer m_long;
};

} // namespace hairpaint::app
