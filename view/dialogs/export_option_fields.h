// The fields of what can be chosen of an export: one for each row of the table of formats.
#pragma once

#include "model/exporting/export_format.h"

#include <functional>
#include <vector>

class QFormLayout;
class QWidget;

namespace hairpaint::view {

/// GUI thread. The widgets belong to the dialog.
class ExportOptionFields
{
public:
    /// Adds all of them to the form.
    ExportOptionFields(QFormLayout& form, QWidget& dialog);
    /// Shows those of the format, and hides the others, which keep what they hold.
    void showFor(const model::ExportFormat& format);
    void fill(const model::ExportRequest& request);
    /// What they hold, also those that are hidden. Defaults of what the format would take and does not ask for.
    void put(model::ExportRequest& request) const;

private:
    struct Field
    {
        const model::ExportOption* option = nullptr;
        QWidget* widget = nullptr;
        std::function<void(const model::ExportRequest& request)> fill;
        std::function<void(model::ExportRequest& request)> put;
    };
    [[nodiscard]] static Field fieldOf(const model::ExportOption& option, QFormLayout& form, QWidget& dialog);

    QFormLayout& m_form;
    std::vector<Field> m_fields;
};

} // namespace hairpaint::view
