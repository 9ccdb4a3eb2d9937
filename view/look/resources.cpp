// A static library's resources are only linked in where something names them.
#include "view/look/resources.h"

#include <QtGlobal>

// The macro declares a function, so it must stand outside every namespace.
static void initialise()
{
    Q_INIT_RESOURCE(hairpaint_view);
#ifdef HAIRPAINT_DRAWN_ICONS
    Q_INIT_RESOURCE(hairpaint_drawn);
#endif
}

namespace hairpaint::view {

void initResources()
{
    initialise();
}

} // namespace hairpaint::view
