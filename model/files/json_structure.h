// The brackets and commas of a text that may be JSON.
#pragma once

#include <QByteArrayView>

namespace hairpaint::model {

/// Calls `visit(at, c)` with each bracket and comma that stands in no string, until it returns false.
template<typename Visit>
void visitJsonStructure(QByteArrayView json, const Visit& visit)
{
    bool inString = false;
    for (qsizetype i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (inString && c == '\\')
            ++i;
        else if (c == '"')
            inString = !inString;
        else if (!inString && QByteArrayView("{}[],").contains(c) && !visit(i, c))
            return;
    }
}

} // namespace hairpaint::model
