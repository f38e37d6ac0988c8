#pragma once

#include "vtkMRMLNumberText.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtksys/SystemTools.hxx>

#include <cstring>
#include <string>
#include <vector>

// How does a node's property go to XML and back, to a copy and to a printout? One line each: within a
// Begin and an End macro, the macro of its type. A property NAME has GetNAME() and SetNAME(); an enum
// has GetNAMEAsString(int) and GetNAMEFromString(const char*), negative where the text is unknown.
// Floating-point numbers are written with all their digits (vtkMRMLNumberText.h).

// --- WriteXML(ostream& of, int indent) -------------------------------------------------------------

#define vtkMRMLWriteXMLBeginMacro(of)                                                              \
  {                                                                                                \
    ostream& xmlWriteOutputStream = of;

#define vtkMRMLWriteXMLEndMacro() }

#define vtkMRMLWriteXMLBooleanMacro(xmlAttributeName, propertyName)                                \
  xmlWriteOutputStream << " " #xmlAttributeName "=\""                                              \
                       << (this->Get##propertyName() ? "true" : "false") << "\"";

#define vtkMRMLWriteXMLStringMacro(xmlAttributeName, propertyName)                                 \
  if (this->Get##propertyName() != nullptr)                                                        \
  {                                                                                                \
    xmlWriteOutputStream << " " #xmlAttributeName "=\""                                            \
                         << vtkMRMLNode::XMLAttributeEncodeString(this->Get##propertyName())       \
                         << "\"";                                                                  \
  }

#define vtkMRMLWriteXMLStdStringMacro(xmlAttributeName, propertyName)                              \
  xmlWriteOutputStream << " " #xmlAttributeName "=\""                                              \
                       << vtkMRMLNode::XMLAttributeEncodeString(this->Get##propertyName())         \
                       << "\"";

#define vtkMRMLWriteXMLEnumMacro(xmlAttributeName, propertyName)                                   \
  {                                                                                                \
    const char* xmlEnumText = this->Get##propertyName##AsString(this->Get##propertyName());        \
    xmlWriteOutputStream << " " #xmlAttributeName "=\""                                            \
                         << vtkMRMLNode::XMLAttributeEncodeString(xmlEnumText ? xmlEnumText : "")  \
                         << "\"";                                                                  \
  }

#define vtkMRMLWriteXMLIntMacro(xmlAttributeName, propertyName)                                    \
  xmlWriteOutputStream << " " #xmlAttributeName "=\"" << this->Get##propertyName() << "\"";

#define vtkMRMLWriteXMLFloatMacro(xmlAttributeName, propertyName)                                  \
  xmlWriteOutputStream << " " #xmlAttributeName "=\""                                              \
                       << vtkMRMLNumberText(this->Get##propertyName()) << "\"";

#define vtkMRMLWriteXMLVectorMacro(xmlAttributeName, propertyName, vectorType, vectorSize)         \
  {                                                                                                \
    xmlWriteOutputStream << " " #xmlAttributeName "=\"";                                           \
    const vectorType* xmlVector = this->Get##propertyName();                                       \
    for (int xmlIndex = 0; xmlVector && xmlIndex < vectorSize; ++xmlIndex)                         \
    {                                                                                              \
      xmlWriteOutputStream << (xmlIndex > 0 ? " " : "")                                            \
                           << vtkMRMLNumberText<vectorType>(xmlVector[xmlIndex]);                  \
    }                                                                                              \
    xmlWriteOutputStream << "\"";                                                                  \
  }

#define vtkMRMLWriteXMLStdFloatVectorMacro(xmlAttributeName, propertyName, vectorType)             \
  {                                                                                                \
    xmlWriteOutputStream << " " #xmlAttributeName "=\"";                                           \
    const vectorType xmlVector = this->Get##propertyName();                                        \
    for (const auto& xmlValue : xmlVector)                                                         \
    {                                                                                              \
      xmlWriteOutputStream << vtkMRMLNumberText(xmlValue) << " ";                                  \
    }                                                                                              \
    xmlWriteOutputStream << "\"";                                                                  \
  }

#define vtkMRMLWriteXMLStdIntVectorMacro(xmlAttributeName, propertyName, vectorType)               \
  vtkMRMLWriteXMLStdFloatVectorMacro(xmlAttributeName, propertyName, vectorType)

#define vtkMRMLWriteXMLStdStringVectorMacro(xmlAttributeName, propertyName, vectorType)            \
  {                                                                                                \
    xmlWriteOutputStream << " " #xmlAttributeName "=\"";                                           \
    const vectorType<std::string> xmlVector = this->Get##propertyName();                           \
    const char* xmlSeparator = "";                                                                 \
    for (std::string xmlText : xmlVector)                                                          \
    {                                                                                              \
      vtksys::SystemTools::ReplaceString(xmlText, "%", "%25");                                     \
      vtksys::SystemTools::ReplaceString(xmlText, ";", "%3B");                                     \
      xmlWriteOutputStream << xmlSeparator << vtkMRMLNode::XMLAttributeEncodeString(xmlText);      \
      xmlSeparator = ";";                                                                          \
    }                                                                                              \
    xmlWriteOutputStream << "\"";                                                                  \
  }

#define vtkMRMLWriteXMLMatrix4x4Macro(xmlAttributeName, propertyName)                              \
  {                                                                                                \
    xmlWriteOutputStream << " " #xmlAttributeName "=\"";                                           \
    const double* xmlElements = this->Get##propertyName()->GetData();                              \
    for (int xmlIndex = 0; xmlIndex < 16; ++xmlIndex)                                              \
    {                                                                                              \
      xmlWriteOutputStream << (xmlIndex > 0 ? " " : "")                                            \
                           << vtkMRMLNumberText(xmlElements[xmlIndex]);                            \
    }                                                                                              \
    xmlWriteOutputStream << "\"";                                                                  \
  }

// --- ReadXMLAttributes(const char** atts) ----------------------------------------------------------

#define vtkMRMLReadXMLBeginMacro(atts)                                                             \
  for (const char** xmlReadAtts = atts; xmlReadAtts[0] && xmlReadAtts[1]; xmlReadAtts += 2)        \
  {                                                                                                \
    const char* xmlReadAttName = xmlReadAtts[0];                                                   \
    const char* xmlReadAttValue = xmlReadAtts[1];

#define vtkMRMLReadXMLEndMacro() }

#define vtkMRMLReadXMLBooleanMacro(xmlAttributeName, propertyName)                                 \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    this->Set##propertyName(std::string(xmlReadAttValue) == "true");                               \
  }

#define vtkMRMLReadXMLStringMacro(xmlAttributeName, propertyName)                                  \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    this->Set##propertyName(xmlReadAttValue);                                                      \
  }

#define vtkMRMLReadXMLStdStringMacro(xmlAttributeName, propertyName)                               \
  vtkMRMLReadXMLStringMacro(xmlAttributeName, propertyName)

#define vtkMRMLReadXMLEnumMacro(xmlAttributeName, propertyName)                                    \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    const int xmlEnum = this->Get##propertyName##FromString(xmlReadAttValue);                      \
    if (xmlEnum >= 0)                                                                              \
    {                                                                                              \
      this->Set##propertyName(xmlEnum);                                                            \
    }                                                                                              \
    else                                                                                           \
    {                                                                                              \
      vtkErrorMacro("Attribute " #xmlAttributeName " has an unknown value: " << xmlReadAttValue);  \
    }                                                                                              \
  }

#define vtkMRMLReadXMLIntMacro(xmlAttributeName, propertyName)                                     \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    double xmlNumber = 0.0;                                                                        \
    if (vtkMRMLNumberFromText(xmlReadAttValue, xmlNumber))                                         \
    {                                                                                              \
      this->Set##propertyName(vtkMRMLIntFromDouble(xmlNumber));                                    \
    }                                                                                              \
    else                                                                                           \
    {                                                                                              \
      vtkErrorMacro("Attribute " #xmlAttributeName " is no integer: " << xmlReadAttValue);         \
    }                                                                                              \
  }

#define vtkMRMLReadXMLFloatMacro(xmlAttributeName, propertyName)                                   \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    double xmlNumber = 0.0;                                                                        \
    if (vtkMRMLNumberFromText(xmlReadAttValue, xmlNumber))                                         \
    {                                                                                              \
      this->Set##propertyName(xmlNumber);                                                          \
    }                                                                                              \
    else                                                                                           \
    {                                                                                              \
      vtkErrorMacro("Attribute " #xmlAttributeName " is no number: " << xmlReadAttValue);          \
    }                                                                                              \
  }

#define vtkMRMLReadXMLVectorMacro(xmlAttributeName, propertyName, vectorType, vectorSize)          \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    vectorType xmlVector[vectorSize] = {};                                                         \
    const char* xmlRest = xmlReadAttValue;                                                         \
    double xmlNumber = 0.0;                                                                        \
    for (int xmlIndex = 0; xmlIndex < vectorSize && vtkMRMLNextNumber(xmlRest, xmlNumber);         \
         ++xmlIndex)                                                                               \
    {                                                                                              \
      xmlVector[xmlIndex] = std::is_integral_v<vectorType>                                         \
                                ? static_cast<vectorType>(vtkMRMLIntFromDouble(xmlNumber))         \
                                : static_cast<vectorType>(xmlNumber);                              \
    }                                                                                              \
    this->Set##propertyName(xmlVector);                                                            \
  }

#define vtkMRMLReadXMLStdFloatVectorMacro(xmlAttributeName, propertyName, vectorType)              \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    vectorType xmlVector;                                                                          \
    const char* xmlRest = xmlReadAttValue;                                                         \
    double xmlNumber = 0.0;                                                                        \
    while (vtkMRMLNextNumber(xmlRest, xmlNumber))                                                  \
    {                                                                                              \
      xmlVector.insert(xmlVector.end(), static_cast<vectorType::value_type>(xmlNumber));           \
    }                                                                                              \
    this->Set##propertyName(xmlVector);                                                            \
  }

#define vtkMRMLReadXMLStdIntVectorMacro(xmlAttributeName, propertyName, vectorType)                \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    vectorType xmlVector;                                                                          \
    const char* xmlRest = xmlReadAttValue;                                                         \
    double xmlNumber = 0.0;                                                                        \
    while (vtkMRMLNextNumber(xmlRest, xmlNumber))                                                  \
    {                                                                                              \
      xmlVector.insert(xmlVector.end(), vtkMRMLIntFromDouble(xmlNumber));                          \
    }                                                                                              \
    this->Set##propertyName(xmlVector);                                                            \
  }

#define vtkMRMLReadXMLStdStringVectorMacro(xmlAttributeName, propertyName, vectorType)             \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    vectorType<std::string> xmlVector;                                                             \
    for (std::string xmlText : vtksys::SystemTools::SplitString(xmlReadAttValue, ';'))             \
    {                                                                                              \
      vtksys::SystemTools::ReplaceString(xmlText, "%3B", ";");                                     \
      vtksys::SystemTools::ReplaceString(xmlText, "%25", "%");                                     \
      xmlVector.emplace_back(xmlText);                                                             \
    }                                                                                              \
    this->Set##propertyName(xmlVector);                                                            \
  }

/// "Owned": the node holds the matrix for ever, and only its elements change.
#define vtkMRMLReadXMLOwnedMatrix4x4Macro(xmlAttributeName, propertyName)                          \
  if (!std::strcmp(xmlReadAttName, #xmlAttributeName))                                             \
  {                                                                                                \
    vtkNew<vtkMatrix4x4> xmlMatrix;                                                                \
    const char* xmlRest = xmlReadAttValue;                                                         \
    double xmlNumber = 0.0;                                                                        \
    for (int xmlIndex = 0; xmlIndex < 16 && vtkMRMLNextNumber(xmlRest, xmlNumber); ++xmlIndex)     \
    {                                                                                              \
      xmlMatrix->SetElement(xmlIndex / 4, xmlIndex % 4, xmlNumber);                                \
    }                                                                                              \
    this->Get##propertyName()->DeepCopy(xmlMatrix);                                                \
  }

// --- Copy and CopyContent(vtkMRMLNode* node) -------------------------------------------------------

#define vtkMRMLCopyBeginMacro(sourceNode)                                                          \
  if (auto* copySourceNode = this->SafeDownCast(sourceNode); !copySourceNode)                      \
  {                                                                                                \
    vtkErrorMacro("Copy: the source is of another class");                                         \
  }                                                                                                \
  else                                                                                             \
  {

#define vtkMRMLCopyEndMacro() }

#define vtkMRMLCopyValueMacro(propertyName)                                                        \
  this->Set##propertyName(copySourceNode->Get##propertyName());

#define vtkMRMLCopyBooleanMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyStringMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyStdStringMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyIntMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyEnumMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyFloatMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyVectorMacro(propertyName, vectorType, vectorSize)                               \
  vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyStdFloatVectorMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyStdIntVectorMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)
#define vtkMRMLCopyStdStringVectorMacro(propertyName) vtkMRMLCopyValueMacro(propertyName)

#define vtkMRMLCopyOwnedMatrix4x4Macro(propertyName)                                               \
  this->Get##propertyName()->DeepCopy(copySourceNode->Get##propertyName());

// --- PrintSelf(ostream& os, vtkIndent indent) ------------------------------------------------------

#define vtkMRMLPrintBeginMacro(os, indent)                                                         \
  {                                                                                                \
    ostream& printOutputStream = os;                                                               \
    vtkIndent printOutputIndent = indent;

#define vtkMRMLPrintEndMacro() }

#define vtkMRMLPrintValueMacro(propertyName, value)                                                \
  printOutputStream << printOutputIndent << #propertyName ": " << (value) << "\n";

#define vtkMRMLPrintBooleanMacro(propertyName)                                                     \
  vtkMRMLPrintValueMacro(propertyName, this->Get##propertyName() ? "true" : "false")
#define vtkMRMLPrintStringMacro(propertyName)                                                      \
  vtkMRMLPrintValueMacro(propertyName,                                                             \
                         this->Get##propertyName() ? this->Get##propertyName() : "(none)")
#define vtkMRMLPrintStdStringMacro(propertyName)                                                   \
  vtkMRMLPrintValueMacro(propertyName, this->Get##propertyName())
#define vtkMRMLPrintEnumMacro(propertyName)                                                        \
  vtkMRMLPrintValueMacro(propertyName, this->Get##propertyName##AsString(this->Get##propertyName()))
#define vtkMRMLPrintIntMacro(propertyName)                                                         \
  vtkMRMLPrintValueMacro(propertyName, this->Get##propertyName())
#define vtkMRMLPrintFloatMacro(propertyName)                                                       \
  vtkMRMLPrintValueMacro(propertyName, this->Get##propertyName())

#define vtkMRMLPrintVectorMacro(propertyName, vectorType, vectorSize)                              \
  {                                                                                                \
    const vectorType* printVector = this->Get##propertyName();                                     \
    printOutputStream << printOutputIndent << #propertyName ": (";                                 \
    for (int printIndex = 0; printVector && printIndex < vectorSize; ++printIndex)                 \
    {                                                                                              \
      printOutputStream << (printIndex > 0 ? ", " : "") << printVector[printIndex];                \
    }                                                                                              \
    printOutputStream << ")\n";                                                                    \
  }

#define vtkMRMLPrintStdFloatVectorMacro(propertyName, vectorType)                                  \
  {                                                                                                \
    const vectorType printVector = this->Get##propertyName();                                      \
    const char* printSeparator = "";                                                               \
    printOutputStream << printOutputIndent << #propertyName ": (";                                 \
    for (const auto& printValue : printVector)                                                     \
    {                                                                                              \
      printOutputStream << printSeparator << printValue;                                           \
      printSeparator = ", ";                                                                       \
    }                                                                                              \
    printOutputStream << ")\n";                                                                    \
  }

#define vtkMRMLPrintStdIntVectorMacro(propertyName, vectorType)                                    \
  vtkMRMLPrintStdFloatVectorMacro(propertyName, vectorType)

#define vtkMRMLPrintStdStringVectorMacro(propertyName, vectorType)                                 \
  vtkMRMLPrintStdFloatVectorMacro(propertyName, vectorType<std::string>)

#define vtkMRMLPrintObjectMacro(propertyName)                                                      \
  {                                                                                                \
    vtkObject* printObject = this->Get##propertyName();                                            \
    printOutputStream << printOutputIndent << #propertyName ":";                                   \
    if (printObject)                                                                               \
    {                                                                                              \
      printOutputStream << "\n";                                                                   \
      printObject->PrintSelf(printOutputStream, printOutputIndent.GetNextIndent());                \
    }                                                                                              \
    else                                                                                           \
    {                                                                                              \
      printOutputStream << " (none)\n";                                                            \
    }                                                                                              \
  }

#define vtkMRMLPrintMatrix4x4Macro(propertyName) vtkMRMLPrintObjectMacro(propertyName)
