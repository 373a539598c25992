/* gbxml_read.h - from a gbXML document to what of it bears on daylight. Inside formats/gbxml/
 * only. */
#ifndef PP_FORMATS_GBXML_GBXML_READ_H
#define PP_FORMATS_GBXML_GBXML_READ_H

#include "formats/gbxml/gbxml_document.h"
#include "formats/gbxml/gbxml_model.h"

/* Fills the model. What is missing, with the default that is taken, and what is not
 * understood and left out are noted by line. PP_BAD_INPUT where the file has no lengths or
 * no spaces. Even after a failure the model can be cleared. */
enum pp_status pp_gbxml_read(struct pp_gbxml_model *model,
                             const struct pp_xml *document, const char *file,
                             struct pp_mistakes *notes, struct pp_error *err);

#endif
