// The fields of the export options: one for each row of the table of formats.
#pragma once

#include "model/formats/export_format.h"

#include <functional>
#include <vector>

class QFormLayout;
class QWidget;

namespace hairpaint::view {

/// GUI thread. The widgets belong to the dialog.
class ExportOptionFields
{
public:
    /// Adds all fields to the form.
    ExportOptionFields(QFormLayout& form, QWidget& dialog);
    /// Shows the fields of the format and hides the others, which keep their values.
    void showFor(const model::ExportFormat& format);
    void fill(const model::ExportRequest& request);
    /// The values of all fields, also of hidden ones; defaults for options that the dialog does not ask for.
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
