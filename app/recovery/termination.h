// Reports requests to end from outside: kill, a closed terminal, the end of a login.
#pragma once

#include <QObject>

#include <memory>

class QSocketNotifier;

namespace hairpaint::app {

/// While it lives, SIGTERM, SIGHUP and SIGINT do not end the process but are told of, on the thread that it was made
/// on; a second one ends it. One at a time. Elsewhere than on Unix nothing is ever told.
class Termination : public QObject
{
    Q_OBJECT
public:
    explicit Termination(QObject* parent = nullptr);
    ~Termination() override;

Q_SIGNALS:
    void wanted();

private:
    std::unique_ptr<QSocketNotifier> m_notifier;
};

} // namespace hairpaint::app
