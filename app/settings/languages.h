// The languages that the program speaks: translations/*.ts, compiled into it.
#pragma once

#include <QString>

#include <utility>
#include <vector>

namespace hairpaint::app {

/// Code and own name, by name: "es" and "Español".
[[nodiscard]] std::vector<std::pair<QString, QString>> languages();

/// Speaks this language from now on, Qt's own dialogs included; an empty or unknown code means the best of those that
/// the system prefers, English where none of them is there. Texts made before stay as they are. Numbers keep the
/// system's form unless a language of other people is asked for. Needs the application object; files are untouched by
/// all this. Returns the language's code.
QString speak(const QString& code = {});

} // namespace hairpaint::app
