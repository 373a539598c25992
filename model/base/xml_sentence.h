/* xml_sentence.h - mistakes in XML that libxml2 finds, in words for people. */
#ifndef PP_MODEL_BASE_XML_SENTENCE_H
#define PP_MODEL_BASE_XML_SENTENCE_H

/* Position of the cause of a mistake: the first byte not yet parsed, the tag before it,
 * or the quotation mark before it. */
enum pp_xml_cause { PP_XML_HERE, PP_XML_TAG, PP_XML_QUOTE };

struct pp_xml_sentence {
    const char *text; /* NULL: there is none for the error */
    enum pp_xml_cause cause;
};

/* Sentence for an error of libxml2 (xmlParserErrors). at: the first byte not yet
 * parsed, of a text that begins at start and extends at least to there. */
struct pp_xml_sentence pp_xml_sentence_of_error(int error, const char *at,
                                                const char *start);

/* The sentence for markup at p, before end, that is not closed. */
const char *pp_xml_sentence_of_unended(const char *p, const char *end);

#endif
