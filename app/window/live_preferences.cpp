// The preferences in use: see the header.
#include "app/window/live_preferences.h"

namespace hairpaint::app {

LivePreferences::LivePreferences(Settings& settings) : m_settings(settings), m_current(settings.preferences()) {}

void LivePreferences::set(const view::Preferences& preferences)
{
    if (preferences == m_current)
        return;
    m_current = preferences;
    m_settings.setPreferences(preferences);
    Q_EMIT changed();
}

} // namespace hairpaint::app
