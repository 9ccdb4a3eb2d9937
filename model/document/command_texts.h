// What the undo list says of commands, in the user's language.
#pragma once

#include <QCoreApplication>

namespace hairpaint::model {

/// The translation context of command texts.
class Commands
{
    Q_DECLARE_TR_FUNCTIONS(Commands)
};

} // namespace hairpaint::model
