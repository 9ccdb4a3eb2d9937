// The preferences that are in use.
#pragma once

#include "app/settings/settings.h"

#include <QObject>

namespace hairpaint::app {

/// Read from the settings once, and kept there with every change. GUI thread.
class LivePreferences : public QObject
{
    Q_OBJECT
public:
    explicit LivePreferences(Settings& settings);
    [[nodiscard]] const view::Preferences& current() const { return m_current; }

public Q_SLOTS:
    void set(const hairpaint::view::Preferences& preferences);

Q_SIGNALS:
    void changed();

private:
    Settings& m_settings;
    view::Preferences m_current;
};

} // namespace hairpaint::app
