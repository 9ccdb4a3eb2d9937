// The selection's setter.
#include "model/tools/selection.h"

namespace hairpaint::model {

void Selection::setRectangle(std::optional<QRectF> rectangle)
{
    if (rectangle == m_rectangle)
        return;
    m_rectangle = rectangle;
    Q_EMIT changed();
}

} // namespace hairpaint::model
