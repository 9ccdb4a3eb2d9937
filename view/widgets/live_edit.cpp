// Previews and the one command that follows them.
#include "view/widgets/live_edit.h"

namespace hairpaint::view {

void previewEdit(model::Document& document, const model::Change& change,
                 const std::function<void(model::Project&)>& edit)
{
    model::Change shown = change;
    shown.preview = true;
    document.setPreview(shown, edit);
}

void commitEdit(model::Document& document, const std::function<model::CommandPtr()>& make)
{
    // Commands start from the committed content and drop the preview themselves, without showing the old content
    // between.
    if (model::CommandPtr command = make())
        document.push(std::move(command));
    else
        document.clearPreview();
}

} // namespace hairpaint::view
