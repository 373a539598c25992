/* xml_sentence.h - user messages for mistakes in XML that libxml2 finds. */
#ifndef PP_MODEL_BASE_XML_SENTENCE_H
#define PP_MODEL_BASE_XML_SENTENCE_H

/* Position of the cause: the first byte not yet parsed, the tag before it, or the
 * quotation mark before it. */
enum pp_xml_cause { PP_XML_HERE, PP_XML_TAG, PP_XML_QUOTE };

struct pp_xml_sentence {
    const char *text; /* NULL: no message for the error */
    enum pp_xml_cause cause;
};

/* Message for an error of libxml2 (xmlParserErrors). at: first byte not yet parsed; the
 * text begins at start and extends at least to `at`. */
struct pp_xml_sentence pp_xml_sentence_of_error(int error, const char *at,
                                                const char *start);

/* Message for markup at p, before end, that is not closed. */
const char *pp_xml_sentence_of_unended(const char *p, const char *end);

#endif
