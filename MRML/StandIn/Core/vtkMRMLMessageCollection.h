#pragma once

#include "vtkMRML.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkCallbackCommand;

/// Tells the user (through the collection, where there is one) and VTK's output window.
#define vtkMRMLTellMacro(vtkMacro, event, self, messageCollection, prefix, text)                   \
  {                                                                                                \
    std::ostringstream toldText;                                                                   \
    toldText << text;                                                                              \
    if (messageCollection)                                                                         \
    {                                                                                              \
      (messageCollection)->AddMessage(event, toldText.str());                                      \
    }                                                                                              \
    vtkMacro(self, << prefix << ": " << toldText.str());                                           \
  }

#define vtkErrorToMessageCollectionMacro(messageCollection, devMsgPrefix, userMsg)                 \
  vtkMRMLTellMacro(vtkErrorWithObjectMacro, vtkCommand::ErrorEvent, this, messageCollection,       \
                   devMsgPrefix, userMsg)

#define vtkWarningToMessageCollectionMacro(messageCollection, devMsgPrefix, userMsg)               \
  vtkMRMLTellMacro(vtkWarningWithObjectMacro, vtkCommand::WarningEvent, this, messageCollection,   \
                   devMsgPrefix, userMsg)

/// What an operation has to say to its user: errors, warnings and notes in their order.
class VTK_MRML_EXPORT vtkMRMLMessageCollection : public vtkObject
{
public:
  static vtkMRMLMessageCollection* New();
  vtkTypeMacro(vtkMRMLMessageCollection, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  virtual int GetNumberOfMessages() const;
  virtual int GetNumberOfMessagesOfType(unsigned long messageType) const;
  virtual unsigned long GetNthMessageType(int index) const;
  virtual std::string GetNthMessageText(int index) const;
  virtual void AddMessage(unsigned long messageType, const std::string& messageText);
  virtual void AddMessages(vtkMRMLMessageCollection* source,
                           const std::string& prefix = std::string());
  virtual void ClearMessages();
  virtual void DeepCopy(vtkMRMLMessageCollection* source);
  virtual std::string GetAllMessagesAsString(bool* errorFound = nullptr,
                                             bool* warningFound = nullptr);
  /// Collects the errors and warnings of an object until another (or none) is given.
  virtual void SetObservedObject(vtkObject* observedObject);

protected:
  vtkMRMLMessageCollection();
  ~vtkMRMLMessageCollection() override;
  vtkMRMLMessageCollection(const vtkMRMLMessageCollection&) = delete;
  void operator=(const vtkMRMLMessageCollection&) = delete;

  static void CallbackFunction(vtkObject*, unsigned long event, void* clientData, void* callData);

private:
  struct Message
  {
    unsigned long Type;
    std::string Text;
  };
  std::vector<Message> Messages;
  vtkSmartPointer<vtkObject> ObservedObject;
  vtkNew<vtkCallbackCommand> CallbackCommand;
};
