/* document_pdf.c - see document_pdf.h. */
#include "cli/document_pdf.h"

#include "cli/output.h"

enum pp_status pp_document_pdf(const struct pp_document *document, const char *title,
                               const char *description, bool landscape,
                               struct pp_canvas *const *pictures, FILE *out,
                               struct pp_error *err)
{
    const struct pp_sheet sheet = {.format = PP_CHART_PDF,
                                   .paper = PP_PAPER_A4,
                                   .landscape = landscape,
                                   .title = title,
                                   .description = description};
    struct pp_canvas *canvas;
    enum pp_status status = pp_canvas_create(&canvas, &sheet, err);
    if (status != PP_OK)
        return status;
    status = pp_document_sheets_draw(canvas, document, title, pictures, err);
    if (status == PP_OK)
        status = pp_canvas_write(canvas, pp_output_put, out, err);
    pp_canvas_destroy(canvas);
    return status;
}
