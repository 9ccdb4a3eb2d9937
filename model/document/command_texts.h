// What the undo list says of commands, in the user's language.
#pragma once

#include <QCoreApplication>

namespace hairpaint::model {

/// Of every command's text.
class Commands
{
    Q_DECLARE_TR_FUNCTIONS(Commands)
};

} // namespace hairpaint::model
