-- | Messages about files and names of polyhedra.
module Message.Solid
  ( solidFileMessage,
    solidNameMessage,
    tooFineMessage,
  )
where

import Message.Format (encodingMessage, formatMessage)
import PraTactile.Format.Solid
import PraTactile.Object.Tolerance (TooFine (..))
import Visible

-- | The message about a file, given its format.
solidFileMessage :: FilePath -> SolidFormat -> SolidFileError -> String
solidFileMessage file format e = case e of
  ObjectRefused why -> formatMessage (visibleName file) "an object" why
  SolidFileError place fault ->
    visibleName file
      ++ ", "
      ++ placeText place
      ++ ": "
      ++ faultText fault
  where
    placeText (AtLine n) = "line " ++ show n
    placeText (AtByte n) = "byte " ++ show n
    faultText fault = case fault of
      Needed what -> what ++ " needed here, in a file of the format " ++ formatName format
      Ends what -> "the file ends before " ++ what
      NotNumber -> "this is not a number"
      NotFinite -> "a coordinate is no finite number"
      TooLargeOrFine -> "a number is beyond 10^300, or has more than 400 decimal places"
      NoSuchVertex i count ->
        "a face names the vertex " ++ show i ++ ", and there are " ++ show count
      LengthDiffers wanted found ->
        "as many triangles as this says take "
          ++ show wanted
          ++ " bytes; the file has "
          ++ show found
      FileInEncoding encoding -> "this file" ++ encodingMessage encoding
      NoCommonDenominator -> "the coordinates have no common denominator below 2^20000"

-- | The message about a malformed name, given the right form.
solidNameMessage :: String -> String -> String
solidNameMessage given form =
  quoted given ++ " is no solid: write " ++ form
    ++ ", with lengths in millimetres above 0, such as 31.75 or 127/4"

-- | Why vertices are not moved.
tooFineMessage :: TooFine -> String
tooFineMessage (TooFine bits) =
  "to be flat its faces would need coordinates of " ++ show bits
    ++ " binary digits over one denominator, and more than 268435456 are not made; leave out "
    ++ "--tolerance, or give fewer faces"
