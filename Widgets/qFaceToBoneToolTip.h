#ifndef qFaceToBoneToolTip_h
#define qFaceToBoneToolTip_h

#include <QString>

/// Every tooltip has three lines: what it is, a typical value, and the technical term.
inline QString qFaceToBoneToolTip(const QString& what, const QString& typical, const QString& term)
{
  return QStringLiteral("<p style='white-space:pre'>%1<br>%2<br><i>%3</i></p>")
      .arg(what.toHtmlEscaped(), typical.toHtmlEscaped(), term.toHtmlEscaped());
}

#endif
