#include "qFaceToBoneCutsPanel.h"

#include "qFaceToBoneCase.h"
#include "qFaceToBoneCut.h"
#include "qFaceToBoneSparedPanel.h"
#include "qFaceToBoneToolTip.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace
{

/// What an item of the list of cuts stands for; part: -1 the whole cut.
constexpr int cutRole = Qt::UserRole, partRole = Qt::UserRole + 1;

QToolButton* makeButton(const QString& text, const char* name)
{
  auto* button = new QToolButton;
  button->setText(text);
  button->setObjectName(name);
  return button;
}

QTreeWidget* makeTree(const QStringList& heads, const char* name, int height)
{
  auto* tree = new QTreeWidget;
  tree->setObjectName(name);
  tree->setHeaderLabels(heads);
  tree->setFixedHeight(height);
  tree->header()->setStretchLastSection(true);
  tree->header()->resizeSection(0, 150);
  tree->setSelectionMode(QAbstractItemView::SingleSelection);
  return tree;
}

/// What a cut is made of, in a few words.
QString wordsOf(const qFaceToBoneCut& cut)
{
  if (!cut.problem.empty())
    return qFaceToBoneCutsPanel::tr("cannot be placed");
  QString words = cut.templateName.empty()
                      ? qFaceToBoneCutsPanel::tr("drawn")
                      : qFaceToBoneCuts::titleOf(QString::fromStdString(cut.templateName));
  if (cut.drawn && !cut.templateName.empty())
    words += qFaceToBoneCutsPanel::tr(", moved");
  return words;
}

} // namespace

qFaceToBoneCutsPanel::qFaceToBoneCutsPanel(qFaceToBoneCase* work, QWidget* parent)
    : QWidget(parent), m_case(work), m_cuts(makeTree({tr("Piece"), tr("Cut")}, "cuts", 118)),
      m_add(makeButton(tr("Add"), "addCut")), m_remove(makeButton(tr("Remove"), "removeCut")),
      m_anew(makeButton(tr("Reset"), "resetCut")), m_undo(makeButton(tr("Undo"), "undoCut")),
      m_redo(makeButton(tr("Redo"), "redoCut")),
      m_tools(new QCheckBox(tr("Show and drag the cuts"))), m_kerf(new QDoubleSpinBox),
      m_depth(new QDoubleSpinBox), m_overrun(new QDoubleSpinBox), m_density(new QDoubleSpinBox),
      m_explode(new QSlider(Qt::Horizontal)), m_fragments(new QLabel)
{
  m_cuts->setToolTip(qFaceToBoneToolTip(tr("The pieces that are cut free, and what by"),
                                        tr("Double-click a name to change it"), tr("osteotomies")));
  m_tools->setObjectName("planes");
  m_tools->setToolTip(
      qFaceToBoneToolTip(tr("Cuts with handles in the 3D view; the ball marks the free piece"),
                         tr("Drag balls, edges, arrows"), tr("bounded planes and swept curves")));
  m_fragments->setWordWrap(true);
  auto* form = new QFormLayout;
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(4, 4, 4, 4);
  page->addLayout(form);
  page->addStretch(1); // on a high screen the rows stay together
  form->setVerticalSpacing(4);
  form->addRow(m_cuts);
  form->addRow(makeCutButtons());
  form->addRow(m_drawing = makeDrawingBox());
  form->addRow(m_tools);
  makeNumbers(form);
  auto* spared = new qFaceToBoneSparedPanel(m_case);
  connect(spared, &qFaceToBoneSparedPanel::refused, this, &qFaceToBoneCutsPanel::refused);
  form->addRow(spared);
  form->addRow(m_fragments);
  connectParts();
  setDrawing(false);
  update();
}

QWidget* qFaceToBoneCutsPanel::makeCutButtons()
{
  auto* menu = new QMenu(m_add);
  for (const QString& name : qFaceToBoneCuts::templates())
    menu->addAction(qFaceToBoneCuts::titleOf(name), this,
                    [this, name]
                    {
                      m_tools->setChecked(true);
                      if (!m_case->cuts()->addTemplate(name))
                        emit refused(m_case->cuts()->error());
                    });
  menu->addSeparator();
  const auto plane = [this](bool ofCurrent)
  {
    m_tools->setChecked(true);
    emit planeWanted(ofCurrent);
  };
  const auto line = [this](bool ofCurrent)
  {
    m_tools->setChecked(true);
    m_explode->setValue(0); // the pen draws on bone that lies together
    emit lineWanted(ofCurrent);
  };
  menu->addAction(tr("Plane at the crosshair"), this, [plane] { plane(false); });
  menu->addAction(tr("Line drawn on the bone"), this, [line] { line(false); });
  menu->addSeparator();
  menu->addAction(tr("To this cut: one more plane"), this, [plane] { plane(true); });
  menu->addAction(tr("To this cut: one more line"), this, [line] { line(true); });
  m_add->setMenu(menu);
  m_add->setPopupMode(QToolButton::InstantPopup);
  m_add->setToolTip(qFaceToBoneToolTip(tr("Another piece to be cut free"),
                                       tr("Template, plane or drawn line"), tr("osteotomy")));
  m_remove->setToolTip(qFaceToBoneToolTip(tr("Removes the chosen cut, or the chosen part of it"),
                                          tr("Undo brings it back"), tr("delete")));
  m_anew->setToolTip(qFaceToBoneToolTip(tr("Puts a template's cut where its landmarks say"),
                                        tr("After dragging it"), tr("template placement")));
  m_undo->setToolTip(
      qFaceToBoneToolTip(tr("Takes the last change of the cuts back"), tr("Ctrl+Z"), tr("undo")));
  m_redo->setToolTip(qFaceToBoneToolTip(tr("Does it again"), tr("Ctrl+Shift+Z"), tr("redo")));
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  for (QToolButton* button : {m_add, m_remove, m_anew, m_undo, m_redo})
    row->addWidget(button);
  row->addStretch(1);
  return buttons;
}

QWidget* qFaceToBoneCutsPanel::makeDrawingBox()
{
  auto* box = new QGroupBox(tr("Drawing a line"));
  auto* how = new QLabel(
      tr("Click along the cut on the bone; with Shift, draw freehand. A click on the first point "
         "closes the line. Backspace takes the last point back; Return or a double click ends."));
  how->setWordWrap(true);
  auto* done = new QPushButton(tr("Done"));
  auto* drop = new QPushButton(tr("Give up"));
  done->setObjectName("finishLine");
  drop->setObjectName("dropLine");
  done->setToolTip(qFaceToBoneToolTip(tr("The line becomes a cut"), tr("Return"), tr("finish")));
  drop->setToolTip(qFaceToBoneToolTip(tr("No cut is made of it"), tr("-"), tr("discard")));
  auto* rows = new QVBoxLayout(box);
  auto* row = new QHBoxLayout;
  rows->addWidget(how);
  rows->addLayout(row);
  row->addWidget(done);
  row->addWidget(drop);
  connect(done, &QPushButton::clicked, this, &qFaceToBoneCutsPanel::lineFinished);
  connect(drop, &QPushButton::clicked, this, &qFaceToBoneCutsPanel::lineDropped);
  return box;
}

void qFaceToBoneCutsPanel::makeNumbers(QFormLayout* form)
{
  m_kerf->setObjectName("kerf");
  m_kerf->setRange(0, 5);
  m_kerf->setSingleStep(0.1);
  m_kerf->setSuffix(" mm");
  m_kerf->setToolTip(qFaceToBoneToolTip(tr("Width of bone that the saw takes at this cut"),
                                        tr("0.5 to 1 mm"), tr("kerf")));
  m_depth->setObjectName("depth");
  m_depth->setRange(1, 200);
  m_depth->setDecimals(1);
  m_depth->setSuffix(" mm");
  m_depth->setToolTip(qFaceToBoneToolTip(tr("How deep the saw goes from this cut's lines"),
                                         tr("15 to 25 mm; a plane's depth is its size"),
                                         tr("blade depth")));
  m_overrun->setObjectName("overrun");
  m_overrun->setRange(0, 30);
  m_overrun->setDecimals(1);
  m_overrun->setSuffix(" mm");
  m_overrun->setToolTip(qFaceToBoneToolTip(tr("How far the saw goes past the ends of open lines"),
                                           tr("4 mm; 0 where a cut ends inside bone"),
                                           tr("run-out of the blade")));
  m_density->setRange(0.05, 4);
  m_density->setSingleStep(0.05);
  m_density->setToolTip(qFaceToBoneToolTip(tr("How finely the tissue is meshed"),
                                           tr("0.3 to try out, 1 for the final plan"),
                                           tr("elements, relative to the reference size")));
  m_explode->setObjectName("explode");
  m_explode->setRange(0, 40);
  m_explode->setToolTip(qFaceToBoneToolTip(tr("Draws the fragments apart, to see the cuts"),
                                           tr("15 mm"), tr("exploded view")));
  for (QWidget* number : {m_kerf, m_depth, m_overrun, m_density})
    number->setMinimumWidth(60);
  auto* sizes = new QHBoxLayout;
  sizes->setSpacing(6);
  sizes->addWidget(m_kerf, 1);
  sizes->addWidget(new QLabel(tr("Depth")));
  sizes->addWidget(m_depth, 1);
  form->addRow(tr("Kerf"), sizes);
  form->addRow(tr("Past its ends"), m_overrun);
  form->addRow(tr("Explode"), m_explode);
  form->addRow(tr("Mesh density"), m_density);
}

void qFaceToBoneCutsPanel::connectParts()
{
  qFaceToBoneCuts* cuts = m_case->cuts();
  connect(m_tools, &QCheckBox::toggled, this, &qFaceToBoneCutsPanel::toolsShown);
  connect(m_remove, &QToolButton::clicked, this, &qFaceToBoneCutsPanel::removeChosen);
  connect(m_anew, &QToolButton::clicked, this,
          [this, cuts]
          {
            if (!cuts->placeAnew(cuts->current()))
              emit refused(cuts->error());
          });
  connect(m_undo, &QToolButton::clicked, cuts, &qFaceToBoneCuts::undo);
  connect(m_redo, &QToolButton::clicked, cuts, &qFaceToBoneCuts::redo);
  connect(m_cuts, &QTreeWidget::currentItemChanged, this,
          [this, cuts](QTreeWidgetItem* item)
          {
            if (item && !m_updating)
              cuts->setCurrent(item->data(0, cutRole).toInt());
          });
  connect(m_cuts, &QTreeWidget::itemChanged, this, &qFaceToBoneCutsPanel::renamed);
  connect(m_kerf, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [cuts](double mm) { cuts->setKerf(cuts->current(), mm); });
  connect(m_depth, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [cuts](double mm) { cuts->setDepth(cuts->current(), mm); });
  connect(m_overrun, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [cuts](double mm) { cuts->setOverrun(cuts->current(), mm); });
  connect(m_density, QOverload<double>::of(&QDoubleSpinBox::valueChanged), m_case,
          &qFaceToBoneCase::setMeshDensity);
  connect(m_explode, &QSlider::valueChanged, this, &qFaceToBoneCutsPanel::explodeChanged);
  connect(m_case, &qFaceToBoneCase::changed, this, &qFaceToBoneCutsPanel::update);
}

bool qFaceToBoneCutsPanel::showsTools() const
{
  return m_tools->isChecked();
}

void qFaceToBoneCutsPanel::setDrawing(bool on)
{
  m_drawing->setVisible(on);
  for (QWidget* other : {static_cast<QWidget*>(m_cuts), static_cast<QWidget*>(m_add),
                         static_cast<QWidget*>(m_remove), static_cast<QWidget*>(m_anew)})
    other->setEnabled(!on);
}

void qFaceToBoneCutsPanel::renamed(QTreeWidgetItem* item)
{
  if (m_updating)
    return;
  qFaceToBoneCuts* cuts = m_case->cuts();
  const int cut = item->data(0, cutRole).toInt();
  const QString name = item->text(0);
  // the list may be made anew: not while one of its items is speaking
  QMetaObject::invokeMethod(
      this,
      [this, cuts, cut, name]
      {
        if (cuts->rename(cut, name))
          return;
        emit refused(cuts->error());
        update();
      },
      Qt::QueuedConnection);
}

void qFaceToBoneCutsPanel::removeChosen()
{
  qFaceToBoneCuts* cuts = m_case->cuts();
  const QTreeWidgetItem* item = m_cuts->currentItem();
  const int part = item ? item->data(0, partRole).toInt() : -1;
  if (part >= 0)
    cuts->removePart(cuts->current(), part);
  else
    cuts->remove(cuts->current());
}

void qFaceToBoneCutsPanel::update()
{
  m_updating = true;
  updateCuts();
  updateNumbers();
  m_updating = false;
  setEnabled(m_case->isOpen() && !m_case->task()->isRunning());
  m_undo->setEnabled(m_case->cuts()->canUndo());
  m_redo->setEnabled(m_case->cuts()->canRedo());
  QStringList names;
  for (const qFaceToBoneObject& o : m_case->objects()->all())
    if (o.key.startsWith("fragment/"))
      names << o.name;
  m_fragments->setText(names.isEmpty() ? tr("Not cut yet. Press Cut to see the fragments.")
                                       : tr("Fragments: %1").arg(names.join(", ")));
}

/// Items are kept where they still fit, so that a choice and an editor that is open stay.
void qFaceToBoneCutsPanel::updateCuts()
{
  const auto& cuts = m_case->cuts()->all();
  const int count = m_case->cuts()->count();
  while (m_cuts->topLevelItemCount() > count)
    delete m_cuts->topLevelItem(m_cuts->topLevelItemCount() - 1);
  for (int c = 0; c < count; ++c)
  {
    const qFaceToBoneCut& cut = cuts[static_cast<std::size_t>(c)];
    QTreeWidgetItem* item = m_cuts->topLevelItem(c);
    if (!item)
    {
      item = new QTreeWidgetItem(m_cuts);
      item->setFlags(item->flags() | Qt::ItemIsEditable);
      QPixmap swatch(12, 12);
      swatch.fill(qFaceToBoneCuts::colour(c));
      item->setIcon(0, swatch);
      item->setData(0, cutRole, c);
      item->setData(0, partRole, -1);
    }
    item->setText(0, QString::fromStdString(cut.fragment));
    item->setText(1, wordsOf(cut));
    item->setToolTip(1, QString::fromStdString(cut.problem));
    std::vector<QString> parts;
    for (const f2b::BoundedPlane& plane : cut.planes)
      parts.push_back(QString::fromStdString(plane.name));
    for (const qFaceToBoneCutCurve& curve : cut.curves)
      parts.push_back(QString::fromStdString(curve.saw.name));
    while (item->childCount() > static_cast<int>(parts.size()))
      delete item->child(item->childCount() - 1);
    for (int k = 0; k < static_cast<int>(parts.size()); ++k)
    {
      QTreeWidgetItem* child = k < item->childCount() ? item->child(k) : new QTreeWidgetItem(item);
      child->setData(0, cutRole, c);
      child->setData(0, partRole, k);
      child->setText(0, parts[static_cast<std::size_t>(k)]);
      child->setText(1, k < static_cast<int>(cut.planes.size()) ? tr("plane") : tr("line"));
    }
  }
  const QTreeWidgetItem* chosen = m_cuts->currentItem();
  const int current = m_case->cuts()->current();
  if (current >= 0 && (!chosen || chosen->data(0, cutRole).toInt() != current))
    m_cuts->setCurrentItem(m_cuts->topLevelItem(current));
}

void qFaceToBoneCutsPanel::updateNumbers()
{
  const QSignalBlocker kerf(m_kerf), depth(m_depth), overrun(m_overrun), density(m_density);
  const int current = m_case->cuts()->current();
  m_kerf->setEnabled(current >= 0);
  m_depth->setEnabled(false);
  m_overrun->setEnabled(false);
  m_anew->setEnabled(false);
  m_remove->setEnabled(current >= 0);
  if (current >= 0)
  {
    const qFaceToBoneCut& cut = m_case->cuts()->all()[static_cast<std::size_t>(current)];
    m_kerf->setValue(cut.kerf);
    m_depth->setEnabled(!cut.curves.empty());
    if (!cut.curves.empty())
      m_depth->setValue(cut.curves.front().saw.depth_mm);
    for (const qFaceToBoneCutCurve& curve : cut.curves)
      if (curve.runsOn())
      {
        m_overrun->setEnabled(true);
        m_overrun->setValue(curve.overrun);
      }
    m_anew->setEnabled(cut.drawn && !cut.templateName.empty());
  }
  m_density->setValue(m_case->meshDensity());
}
